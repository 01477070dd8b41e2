#pragma once

#include <memory>
#include <vector>

#include "server/solver/cycle/backend.h"
#include "server/solver/multi/lock_step.h"
#include "server/solver/multi/shard.h"

namespace burnish {

/// The backends of all shards, and what they need to the end.
struct ShardBackends {
  std::shared_ptr<const Shards> shards;
  std::shared_ptr<LockStep> steps;
  std::shared_ptr<void> halos;
  std::vector<std::unique_ptr<Backend>> backends;
};

/// Makes one backend of those of a scan's shards. It makes every call for all of them in lock-step;
/// for the depths that are whole, for the first one alone. Same input and same number of shards,
/// same bits; other numbers of shards differ by rounding.
std::unique_ptr<Backend> make_multi_backend(const Multigrid& on, ShardBackends of_shards);

}  // namespace burnish
