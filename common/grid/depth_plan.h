#pragma once

#include <cstdint>

#include "common/base/limits.h"
#include "common/mesh/statistics.h"

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

}  // namespace burnish
