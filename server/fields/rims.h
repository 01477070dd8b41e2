#pragma once

#include <cstdint>
#include <vector>

#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Returns the cells that hold an edge or a vertex of a rim, rising. A rim is where the surface
/// ends. A rim beside another piece of the surface does not count: raw scans overlap there.
std::vector<int32_t> rim_cells(const PreparedMesh& prepared);

/// Returns whether the surface encloses a volume: it has no rim, and its triangles agree on the
/// outside.
bool is_closed(const PreparedMesh& prepared);

}  // namespace burnish
