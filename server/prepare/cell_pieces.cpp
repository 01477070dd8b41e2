#include "server/prepare/cell_pieces.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "common/base/process_memory.h"
#include "server/prepare/clip.h"

namespace burnish {

static constexpr size_t kTrianglesPerBlock = 4096;
static constexpr int kDigitBits = 11;
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

struct CutTriangle {
  uint32_t index;
  std::array<Vec3d, 3> corners;
  std::vector<CellColumn> columns;
};

// Calls visit(const CutTriangle&) for those with area, as long as it returns true.
template <typename Visit>
static void for_each_triangle_of_block(std::span<const Triangle> triangles,
                                       std::span<const Vec3d> grid_positions, size_t block,
                                       Visit&& visit) {
  CutTriangle cut;
  const size_t end = std::min(triangles.size(), (block + 1) * kTrianglesPerBlock);
  for (size_t t = block * kTrianglesPerBlock; t < end; ++t) {
    cut.corners = positions_of(triangles[t], grid_positions);
    if (!has_area(cut.corners)) continue;
    cut.index = static_cast<uint32_t>(t);
    find_columns(cut.corners, cut.columns);
    if (!visit(cut)) return;
  }
}

static uint64_t cell_count(const CutTriangle& triangle) {
  uint64_t count = 0;
  for (const CellColumn& column : triangle.columns) count += column.k.last - column.k.first + 1;
  return count;
}

// Where the pieces of each block begin, and how many there are in all. Counting ends where there is
// no memory for more: large triangles in a fine grid have more cells than could be counted to.
static Result<std::vector<uint64_t>> count_pieces(std::span<const Triangle> triangles,
                                                  std::span<const Vec3d> grid_positions) {
  const uint64_t available = available_memory_bytes();
  const uint64_t limit = available / (2 * sizeof(CellPiece));  // the sort works beside its input
  const size_t blocks = (triangles.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
  std::vector<uint64_t> start(blocks + 1, 0);
  std::atomic<uint64_t> total{0};
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < blocks; ++block) {
    if (total > limit) continue;
    uint64_t& count = start[block + 1];
    const auto add_count = [&](const CutTriangle& triangle) {
      count += cell_count(triangle);
      return count <= limit;
    };
    for_each_triangle_of_block(triangles, grid_positions, block, add_count);
    total += count;
  }
  if (total > limit)
    return resource_exhausted("cutting the mesh at this depth gives more than " +
                              std::to_string(limit) + " pieces, for which the available " +
                              std::to_string(available >> 20) +
                              " MiB are too few; choose a smaller depth");
  for (size_t block = 0; block < blocks; ++block) start[block + 1] += start[block];
  return start;
}

// Puts the pieces in the order of one digit of their cells' keys; of one digit they keep theirs.
static void order_by_digit(const UnsetVector<CellPiece>& from, int shift,
                           UnsetVector<CellPiece>& to) {
  constexpr size_t kDigits = 1 << kDigitBits, kChunks = 16;  // a chunk is one thread's
  const auto digit_of = [&](const CellPiece& piece) { return piece.cell >> shift & (kDigits - 1); };
  const auto chunk_start = [&](size_t chunk) { return from.size() * chunk / kChunks; };
  std::vector<size_t> next(kChunks * kDigits, 0);  // by chunk, then digit
#pragma omp parallel for schedule(static)
  for (size_t chunk = 0; chunk < kChunks; ++chunk)
    for (size_t i = chunk_start(chunk); i < chunk_start(chunk + 1); ++i)
      ++next[chunk * kDigits + digit_of(from[i])];
  size_t before = 0;
  for (size_t digit = 0; digit < kDigits; ++digit)
    for (size_t chunk = 0; chunk < kChunks; ++chunk)
      before += std::exchange(next[chunk * kDigits + digit], before);
#pragma omp parallel for schedule(static)
  for (size_t chunk = 0; chunk < kChunks; ++chunk)
    for (size_t i = chunk_start(chunk); i < chunk_start(chunk + 1); ++i)
      to[next[chunk * kDigits + digit_of(from[i])]++] = from[i];
}

// By cell. Pieces of a cell stay in the order of their triangles, as which they come.
static void sort_by_cell(UnsetVector<CellPiece>& pieces) {
  MortonKey bits = 0;
  for (const CellPiece& piece : pieces) bits |= piece.cell;
  UnsetVector<CellPiece> ordered(pieces.size());
  for (int shift = 0; bits >> shift != 0; shift += kDigitBits) {
    order_by_digit(pieces, shift, ordered);
    pieces.swap(ordered);
  }
}

Result<UnsetVector<CellPiece>> find_cell_pieces(std::span<const Triangle> triangles,
                                                std::span<const Vec3d> grid_positions,
                                                const Progress& progress) {
  ASSIGN_OR_RETURN(const std::vector<uint64_t> start, count_pieces(triangles, grid_positions));
  if (!report(progress, "grid", 0.4)) return cancelled("cancelled while cutting at the grid");

  UnsetVector<CellPiece> pieces(start.back());
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < start.size() - 1; ++block) {
    uint64_t next = start[block];
    const auto add_pieces = [&](const CutTriangle& triangle) {
      for_each_cell_with_passages(triangle.corners, triangle.columns,
                                  [&](const Vec3i& cell, Passages passages) {
                                    pieces[next++] = {morton_key(cell), triangle.index, passages};
                                  });
      return true;
    };
    for_each_triangle_of_block(triangles, grid_positions, block, add_pieces);
  }
  if (!report(progress, "grid", 0.7)) return cancelled("cancelled while cutting at the grid");
  sort_by_cell(pieces);
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
