#pragma once

#include <cstdint>
#include <vector>

#include "server/prepare/pages/page_vertices.h"

namespace burnish {

/// Per vertex a bit for each axis: the vertex lies on a plane between cells of some depth, and all
/// its triangles lie below the plane or in it, one at least below.
/// Rounding down would put such a vertex into a cell without surface.
std::vector<uint8_t> find_vertices_below_planes(const PagesInput& scan, const PageGrid& grid);

}  // namespace burnish
