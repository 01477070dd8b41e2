#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/hierarchy.h"
#include "server/solver/hierarchy/patches.h"

namespace burnish {

/// A scan is cut into shards, one for each device. Only its finest depths are split. The border
/// depth and the coarser ones are whole in the first shard.
inline constexpr int kShardsMax = 64;

/// The border is the deepest depth with at most this many corners: work on a smaller one takes less
/// time than exchanges.
inline constexpr int32_t kWholeCornersMax = 400'000;

/// Says which shard owns each cell and corner, from the border depth on.
struct Cut {
  struct Owners {
    std::vector<uint8_t> cell, corner;
  };

  int shards = 1;
  int border = 0;              ///< depth
  std::vector<Owners> owners;  ///< the border depth's first; its corners are all of the first shard

  const Owners& at(int depth) const { return owners[depth - border]; }
};

/// Returns the border depth, which is always above the finest. Needs: two depths.
int border_depth(const Hierarchy& hierarchy, int32_t whole_corners_max = kWholeCornersMax);

/// Cuts the border depth's cells into runs of as many finest cells each; a finer cell goes with its
/// parent, a small component's with the coarse cell that it follows. The lowest shard that touches
/// a corner owns it. Patches that have a cell in common go to one shard with all their corners. So
/// shards solve them without each other.
Cut cut_hierarchy(const Hierarchy& hierarchy, const Patches& patches, int shards, int border);

}  // namespace burnish
