#pragma once

#include <memory>
#include <vector>

#include "server/solver/cpu/halo.h"
#include "server/solver/cycle/backend.h"
#include "server/solver/multi/lock_step.h"
#include "server/solver/multi/shard.h"

namespace burnish {

/// A CPU backend for each shard, and the halos between them.
struct CpuShards {
  std::vector<std::unique_ptr<cpu::Halo>> halos;
  std::vector<std::unique_ptr<Backend>> backends;
};

/// Processors gain nothing from shards: this is where tests try them. Needs: `steps` lives longer.
CpuShards make_cpu_shards(std::shared_ptr<const Shards> shards, LockStep& steps);

}  // namespace burnish
