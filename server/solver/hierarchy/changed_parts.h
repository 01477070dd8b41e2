#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "server/prepare/prepared_mesh.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish {

/// Parts that other α of some cells change at one depth. A depth's parts are what has numbers: its
/// cells, then its ties, or at the finest depth its sheets. All lists rise.
struct ChangedDepth {
  std::vector<int32_t> parts;  ///< whose numbers change
  std::vector<int32_t> rows;   ///< corners whose row of S changes
  /// Parts whose numbers must be made again: to sum these rows and the numbers of the depth above.
  std::vector<int32_t> needed;
};

/// Finds what other α of `cells` change at all depths, the coarsest first. The depths from
/// `depths_not_kept` above the finest on keep their numbers, so only their changed parts are
/// needed. Shapes: cells of the finest depth, each once.
std::vector<ChangedDepth> find_changed_parts(const PreparedMesh& prepared,
                                             const Hierarchy& hierarchy,
                                             std::span<const int32_t> cells,
                                             size_t depths_not_kept);

/// The cells around some corners, and all their corners, which are a superset. Both rise.
struct CellsAround {
  std::vector<int32_t> cells;
  std::vector<int32_t> corners;
};

CellsAround find_cells_around(const HierarchyDepth& depth, std::span<const int32_t> corners);

}  // namespace burnish
