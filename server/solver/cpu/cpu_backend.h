#pragma once

#include <memory>

#include "server/solver/backend.h"
#include "server/solver/hierarchy.h"
#include "server/solver/solver.h"

namespace burnish {

/// The OpenMP backend: float32 V-cycle, double outer iteration; the same bits for any number of
/// threads.
std::unique_ptr<Backend> make_cpu_backend(std::shared_ptr<const PreparedMesh> prepared,
                                          std::shared_ptr<const Hierarchy> hierarchy,
                                          Smoother smoother);

}  // namespace burnish
