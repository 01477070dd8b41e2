#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/hierarchy.h"
#include "server/solver/multi/shard_sets.h"

namespace burnish {

/// Finds the indices that a depth's corners, cells and ties have in a shard; kNone where the shard
/// has them not.
struct LocalIndices {
  std::vector<int32_t> corner, part;

  LocalIndices(const HierarchyDepth& whole, const DepthSets& sets);
};

/// The depth above or below one that is made.
struct NeighbourDepth {
  const HierarchyDepth& whole;
  const DepthSets& sets;
  const LocalIndices& local;
};

/// Makes a shard's depth. `coarse` is the depth above, with the grid that was made of it; null at
/// the border, where only the first shard has rows. `fine` is the depth below; null at the finest.
HierarchyDepth make_shard_depth(const NeighbourDepth& depth, const NeighbourDepth* coarse,
                                const SparseGrid* coarse_grid, const NeighbourDepth* fine);

}  // namespace burnish
