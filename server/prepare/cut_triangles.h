#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "server/prepare/clip.h"
#include "server/prepare/grid_mesh.h"

namespace burnish {

/// A triangle, and the cells that it meets.
struct CutTriangle {
  uint32_t index;
  std::array<Vec3d, 3> corners;
  std::vector<CellColumn> columns;
};

/// Triangles are cut in blocks, each by one thread.
inline constexpr size_t kTrianglesPerBlock = 4096;

inline size_t block_count(const GridMesh& mesh) {
  return (mesh.triangles.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
}

/// Returns false where clipping would leave slivers of rounding, in cells without surface.
bool has_area(const std::array<Vec3d, 3>& corners);

/// Calls visit(const CutTriangle&) for the triangles of a block with area, as long as it returns
/// true.
template <typename Visit>
void for_each_triangle_of_block(const GridMesh& mesh, size_t block, Visit&& visit) {
  CutTriangle cut;
  const size_t end = std::min(mesh.triangles.size(), (block + 1) * kTrianglesPerBlock);
  for (size_t t = block * kTrianglesPerBlock; t < end; ++t) {
    cut.index = static_cast<uint32_t>(t);
    cut.corners = mesh.corners(cut.index);
    if (!has_area(cut.corners)) continue;
    find_columns(cut.corners, cut.columns);
    if (!visit(cut)) return;
  }
}

}  // namespace burnish
