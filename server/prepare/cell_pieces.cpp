#include "server/prepare/cell_pieces.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

#include "common/base/parallel.h"
#include "server/prepare/clip.h"

namespace burnish {

static constexpr size_t kTrianglesPerBlock = 4096;
static constexpr int kDigitBits = 11;
static constexpr double kDegenerateRatio = 1e-12;  // twice the area over the longest edge squared

static std::array<Vec3d, 3> positions_of(const Triangle& triangle,
                                         std::span<const Vec3d> grid_positions) {
  return {grid_positions[triangle[0]], grid_positions[triangle[1]], grid_positions[triangle[2]]};
}

// Clipping a triangle without area would leave slivers of rounding, in cells without surface.
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

// Calls visit(const CutTriangle&) for triangles with area, as long as it returns true.
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

Result<PieceCount> count_cell_pieces(std::span<const Triangle> triangles,
                                     std::span<const Vec3d> grid_positions, uint64_t pieces_max) {
  const size_t blocks = (triangles.size() + kTrianglesPerBlock - 1) / kTrianglesPerBlock;
  std::vector<uint64_t> start(blocks + 1, 0);
  std::atomic<uint64_t> total{0};
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < blocks; ++block) {
    if (total > pieces_max) continue;
    uint64_t& count = start[block + 1];
    const auto add_count = [&](const CutTriangle& triangle) {
      count += cell_count(triangle);
      return count <= pieces_max;
    };
    failure.run([&] {
      for_each_triangle_of_block(triangles, grid_positions, block, add_count);
      total += count;
    });
  }
  failure.rethrow();
  if (total > pieces_max)
    return resource_exhausted("cutting the scan at this depth gives more than " +
                              std::to_string(pieces_max) + " pieces");
  for (size_t block = 0; block < blocks; ++block) start[block + 1] += start[block];
  return PieceCount{std::move(start)};
}

// Calls visit(place, cell, passages, triangle) for every pair, from several threads.
template <typename Visit>
static void for_each_piece(std::span<const Triangle> triangles,
                           std::span<const Vec3d> grid_positions, const PieceCount& count,
                           Visit&& visit) {
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic)
  for (size_t block = 0; block < count.start.size() - 1; ++block) {
    uint64_t next = count.start[block];
    const auto visit_pieces = [&](const CutTriangle& triangle) {
      for_each_cell_with_passages(triangle.corners, triangle.columns,
                                  [&](const Vec3i& cell, Passages passages) {
                                    visit(next++, morton_key(cell), passages, triangle.index);
                                  });
      return true;
    };
    failure.run(
        [&] { for_each_triangle_of_block(triangles, grid_positions, block, visit_pieces); });
  }
  failure.rethrow();
}

// Sorts the pieces by one digit of their cells' keys; pieces of one digit keep their order.
static void order_by_digit(const UnsetVector<CellPiece>& from, int shift,
                           UnsetVector<CellPiece>& to) {
  constexpr size_t kDigits = 1 << kDigitBits, kChunks = 16;  // one chunk per thread
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

// Sorts by cell. Pieces of a cell stay in the order of their triangles.
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
                                                const PieceCount& count, const Progress& progress) {
  UnsetVector<CellPiece> pieces(count.total());
  for_each_piece(triangles, grid_positions, count,
                 [&](uint64_t place, MortonKey cell, Passages passages, uint32_t triangle) {
                   pieces[place] = {cell, triangle, passages};
                 });
  if (!report(progress, "grid", 0.7)) return cancelled("cancelled while cutting at the grid");
  sort_by_cell(pieces);
  return pieces;
}

uint64_t count_cells(std::span<const Triangle> triangles, std::span<const Vec3d> grid_positions,
                     const PieceCount& count) {
  UnsetVector<MortonKey> cells(count.total());
  for_each_piece(triangles, grid_positions, count,
                 [&](uint64_t place, MortonKey cell, Passages, uint32_t) { cells[place] = cell; });
  parallel_sort(cells.begin(), cells.end(), std::less<>());
  return static_cast<uint64_t>(std::unique(cells.begin(), cells.end()) - cells.begin());
}

uint64_t count_cells(std::span<const CellPiece> pieces) {
  uint64_t cells = 0;
  for (size_t i = 0; i < pieces.size(); ++i)
    cells += i == 0 || pieces[i].cell != pieces[i - 1].cell;
  return cells;
}

std::vector<size_t> cell_starts(std::span<const CellPiece> pieces) {
  std::vector<size_t> starts;
  starts.reserve(count_cells(pieces) + 1);
  for (size_t i = 0; i < pieces.size(); ++i)
    if (i == 0 || pieces[i].cell != pieces[i - 1].cell) starts.push_back(i);
  starts.push_back(pieces.size());
  return starts;
}

}  // namespace burnish
