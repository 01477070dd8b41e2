#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/cycle/multigrid.h"
#include "server/solver/multi/shard_sets.h"

namespace burnish {

/// One device's part of a scan: a multigrid that a backend takes for a whole one, and what ties it
/// to the other shards. The first shard also has all depths above the border.
struct Shard {
  Multigrid on;
  std::vector<HaloLists> halos;  ///< from the border depth on
  BorderLists border;
  // Indices in the whole scan.
  std::vector<int32_t> corners;   ///< of the finest depth, own ones first
  std::vector<int32_t> cells;     ///< of the finest depth, rising
  std::vector<int32_t> vertices;  ///< those that lie in own cells, rising
  int32_t own_corners = 0;        ///< of the finest depth
};

/// All shards of a scan.
struct Shards {
  int border = 0;  ///< depth
  std::vector<Shard> all;

  int count() const { return static_cast<int>(all.size()); }
};

/// Says whether shards have copies of their cells' integrals, the largest array of a scan. Who
/// copies them to a device takes them from the whole scan.
enum class ShardIntegrals { kCopied, kLeft };

/// Makes a shard of these sets.
Shard make_shard(const Multigrid& on, const Cut& cut, int number, const ShardSets& sets,
                 ShardIntegrals integrals = ShardIntegrals::kCopied);

Shards make_shards(const Multigrid& on, const Cut& cut,
                   ShardIntegrals integrals = ShardIntegrals::kCopied);

/// Cuts a scan into shards. Needs: two depths.
Shards make_shards(const Multigrid& on, int count, int32_t whole_corners_max = kWholeCornersMax,
                   ShardIntegrals integrals = ShardIntegrals::kCopied);

}  // namespace burnish
