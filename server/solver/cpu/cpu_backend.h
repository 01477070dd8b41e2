#pragma once

#include <memory>

#include "server/solver/cycle/backend.h"
#include "server/solver/cycle/multigrid.h"
#include "server/solver/cycle/smoother_names.h"

namespace burnish {

namespace cpu {
class Halo;
}

/// Makes the OpenMP backend: float32 V-cycle, double outer iteration. It gives the same bits for
/// any number of threads.
std::unique_ptr<Backend> make_cpu_backend(Multigrid on, Smoother smoother);

/// Makes the same over one shard of a scan, with the smoother kSchwarz. Needs: `halo` lives longer.
std::unique_ptr<Backend> make_cpu_shard_backend(Multigrid on, cpu::Halo& halo);

}  // namespace burnish
