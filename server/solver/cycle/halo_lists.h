#pragma once

#include <cstdint>
#include <vector>

#include "common/base/groups.h"

namespace burnish {

/// Says what a shard of a scan (solver/multi) and the others exchange at one depth. Ghosts are
/// corners of other shards next to its own ones. A depth's vectors have own corners first, then
/// ghosts.
struct HaloLists {
  /// A place in a list of another shard.
  struct Place {
    int32_t shard, index;
    bool operator==(const Place&) const = default;
  };
  std::vector<int32_t> sent;  ///< own corners that are ghosts of others, rising
  Groups<Place> copies;       ///< per sent corner, by shard: its index among the other's ghosts
  std::vector<Place> ghosts;  ///< per ghost: its owner, and its index in the owner's `sent`

  uint64_t byte_count() const {
    return sent.capacity() * sizeof(int32_t) + copies.byte_count() +
           ghosts.capacity() * sizeof(Place);
  }
};

/// The cells and ties of the border depth whose numbers a shard makes for the first shard.
struct BorderLists {
  std::vector<int32_t> here;   ///< indices in this shard: cells, then cells + ties
  std::vector<int32_t> whole;  ///< the same in the whole depth
};

}  // namespace burnish
