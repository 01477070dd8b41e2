#pragma once

#include <cstdint>
#include <vector>

#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// A rim below one of these lengths is a flaw of the scan, and is not held: a hold would leave a
/// spot of the old surface around it (docs/solver.md, section 10).
inline constexpr double kHeldRimCellsMin = 16;        // about five cells across
inline constexpr double kHeldRimDiagonalsMin = 0.05;  // of the scan's box

/// Returns the cells that hold an edge or a vertex of a long rim, rising. A rim is where the
/// surface ends. A rim beside another piece of the surface does not count: raw scans overlap there.
std::vector<int32_t> rim_cells(const PreparedMesh& prepared);

/// Returns the bytes that rim_cells() takes at its peak. `rims`: no fewer edges than it finds.
/// Accuracy: no less than it takes.
uint64_t rim_cells_bytes(uint64_t vertices, uint64_t triangles, uint64_t cells, uint64_t rims);

/// Returns whether the surface encloses a volume: it has no rim, and its triangles agree on the
/// outside.
bool is_closed(const PreparedMesh& prepared);

}  // namespace burnish
