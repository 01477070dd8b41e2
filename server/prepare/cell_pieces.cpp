#include "server/prepare/cell_pieces.h"

#include <algorithm>

#include "common/base/parallel.h"
#include "common/base/process_memory.h"
#include "server/prepare/clip.h"

namespace burnish {

static constexpr size_t kTrianglesPerBlock = 4096;
static constexpr double kDegenerateRatio = 1e-12;  // twice the area over the longest edge squared

static std::array<Vec3d, 3> positions_of(const Triangle& triangle,
                                         std::span<const Vec3d> grid_positions) {
  return {grid_positions[triangle[0]], grid_positions[triangle[1]], grid_positions[triangle[2]]};
}

// Clipping a triangle without area leaves slivers of rounding: cells where there is no surface.
static bool has_area(const std::array<Vec3d, 3>& corners) {
  const Vec3d ab = corners[1] - corners[0], bc = corners[2] - corners[1];
  const Vec3d ca = corners[0] - corners[2];
  const double longest = std::max({ab.squaredNorm(), bc.squaredNorm(), ca.squaredNorm()});
  return ab.cross(ca).norm() > kDegenerateRatio * longest;
}

template <typename Visit>
static void for_each_pair_of_block(std::span<const Triangle> triangles,
                                   std::span<const Vec3d> grid_positions, size_t block,
                                   Visit&& visit) {
  const size_t end = std::min(triangles.size(), (block + 1) * kTrianglesPerBlock);
  for (size_t t = block * kTrianglesPerBlock; t < end; ++t) {
    const std::array<Vec3d, 3> corners = positions_of(triangles[t], grid_positions);
    if (!has_area(corners)) continue;
    for_each_cell_of_triangle(corners, [&](const Vec3i& cell) {
      visit(CellPiece{morton_key(cell), static_cast<uint32_t>(t)});
    });
  }
}

static Status check_memory(uint64_t pairs) {
  const uint64_t bytes = 2 * pairs * sizeof(CellPiece);  // the sort works beside its input
  const uint64_t available = available_memory_bytes();
  if (bytes <= available) return Status::ok();
  return resource_exhausted("cutting the mesh at this depth gives " + std::to_string(pairs) +
                            " pieces, which take " + std::to_string(bytes >> 20) +
                            " MiB; available are " + std::to_string(available >> 20) +
                            " MiB; choose a smaller depth");
}

static bool by_cell_then_triangle(const CellPiece& a, const CellPiece& b) {
  return a.cell != b.cell ? a.cell < b.cell : a.triangle < b.triangle;
}

Result<std::vector<CellPiece>> find_cell_pieces(std::span<const Triangle> triangles,
                                                std::span<const Vec3d> grid_positions,
                                                const Progress& progress) {
  const size_t blocks = (triangles.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
  std::vector<uint64_t> start(blocks + 1, 0);
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < blocks; ++block)
    for_each_pair_of_block(triangles, grid_positions, block,
                           [&](const CellPiece&) { ++start[block + 1]; });
  for (size_t block = 0; block < blocks; ++block) start[block + 1] += start[block];
  if (!report(progress, "grid", 0.4)) return cancelled("cancelled while cutting at the grid");
  RETURN_IF_ERROR(check_memory(start.back()));

  std::vector<CellPiece> pieces(start.back());
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < blocks; ++block) {
    uint64_t next = start[block];
    for_each_pair_of_block(triangles, grid_positions, block,
                           [&](const CellPiece& piece) { pieces[next++] = piece; });
  }
  if (!report(progress, "grid", 0.7)) return cancelled("cancelled while cutting at the grid");
  parallel_sort(pieces.begin(), pieces.end(), by_cell_then_triangle);
  return pieces;
}

std::vector<size_t> cell_starts(std::span<const CellPiece> pieces) {
  std::vector<size_t> starts;
  for (size_t i = 0; i < pieces.size(); ++i)
    if (i == 0 || pieces[i].cell != pieces[i - 1].cell) starts.push_back(i);
  starts.push_back(pieces.size());
  return starts;
}

}  // namespace burnish
