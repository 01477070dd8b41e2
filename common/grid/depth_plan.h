#pragma once

#include <cstdint>

#include "common/base/limits.h"
#include "common/mesh/statistics/statistics.h"

namespace burnish {

/// The cost of a depth, as far as it is known before a scan is prepared.
struct DepthPlan {
  int depth = kDepthMin;
  double cell_size = 1;        ///< file units; the shortest wave is two cells
  double cells = 0;            ///< about
  double memory_bytes = 0;     ///< about: the prepared scan with one session
  double prepare_seconds = 0;  ///< about, on two cores
};

/// Estimates from the area of the surface. Accuracy: about a factor of 1.5 for a smooth surface, 3
/// for a crumpled one.
/// Needs: kDepthMin <= depth <= kDepthMax; a box that is not empty.
DepthPlan plan_depth(const MeshStatistics& statistics, int depth);

/// Returns the depth at which a cell is about 1.5 mean edges, or the deepest above it whose plan
/// fits: it takes at most `memory_bytes_max`. Few triangles of many sizes do not ask for a deep
/// grid: beyond depth 9 it has no more cells than the scan has triangles.
/// Needs: a box that is not empty.
int default_depth(const MeshStatistics& statistics, uint64_t memory_bytes_max);

/// Returns the part of a machine's memory that a default depth may take: half of it, so that
/// another scan can be opened beside it.
constexpr uint64_t memory_of_default_depth(uint64_t memory_bytes) {
  return memory_bytes / 2;
}

}  // namespace burnish
