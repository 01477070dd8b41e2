#pragma once

#include <cstdint>
#include <vector>

#include "common/base/groups.h"
#include "common/base/types.h"
#include "common/pages/page.h"

namespace burnish {

/// Private to this folder: the triangles of a page as charts grow over them.
struct FacetGraph {
  std::vector<Vec3d> area_vectors;  ///< along the normal, as long as twice the area; steps²
  std::vector<Vec3d> normals;       ///< unit length, or zero without an area
  /// The triangles across each triangle's sides. Sides at the same positions meet, also where their
  /// vertices are doubled. Where more than two triangles meet, each has the one before and after.
  Groups<uint16_t> neighbours;
};

FacetGraph facet_graph(const Page& page);

}  // namespace burnish
