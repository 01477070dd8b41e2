#pragma once

#include <cstdint>
#include <vector>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/cycle/halo_lists.h"
#include "server/solver/hierarchy/hierarchy.h"
#include "server/solver/multi/cut.h"

namespace burnish {

/// A shard's parts of one depth, as indices in the whole depth.
struct DepthSets {
  std::vector<int32_t> corners;  ///< own corners, then ghosts, then the fringe; each rising
  int32_t own = 0, ghosts = 0;   ///< how many of these
  std::vector<int32_t> parts;    ///< cells, then cells + ties or sheets (sources.h); rising
  int32_t cells = 0;             ///< how many of these are cells
  std::vector<uint8_t> is_made;  ///< per part: this shard makes its numbers. Not so for some of the
                                 ///< border depth
};

/// A shard's parts, from the border depth on.
struct ShardSets {
  int border = 0;
  std::vector<DepthSets> depths;

  const DepthSets& at(int depth) const { return depths[depth - border]; }
  DepthSets& at(int depth) { return depths[depth - border]; }
};

/// Finds what a shard needs so that it makes the rows of S and M⁻¹ of its own corners alone:
///
/// - Ghosts are the columns of own rows, and the corners from which own finer corners are
/// prolonged.
/// - A block of M⁻¹ has entries between ghosts. So rows of ghosts are made too, from all cells
///   around them.
/// - Numbers of a coarse cell need those of its sources, down to the finest depth. So cells at the
///   cut are made by several shards, with the same bits.
/// - At the border the first shard has all corners. Others have ghosts alone.
ShardSets find_shard_sets(const PreparedMesh& prepared, const Hierarchy& hierarchy, const Cut& cut,
                          int shard);

/// Returns what each shard exchanges at one depth.
std::vector<HaloLists> find_halo_lists(const Cut& cut, const std::vector<ShardSets>& shards,
                                       int depth);

}  // namespace burnish
