#pragma once

#include <cstdint>
#include <vector>

#include "common/base/types.h"
#include "common/sheets/facet_graph.h"

namespace burnish {

/// Private to this folder: triangles that face one direction.
struct GrownChart {
  std::vector<uint16_t> triangles;  ///< in the order in which they were reached
  Vec3d axis;                       ///< unit length
};

/// Puts each triangle into a chart. A chart grows from the largest triangle that is left, over
/// neighbours that face the mean of what it has. Triangles that the final mean leaves behind begin
/// anew. Small charts join a neighbour that faces as they do. Ties go to the lower number, so a
/// page always has the same charts.
std::vector<GrownChart> grow_charts(const FacetGraph& graph);

}  // namespace burnish
