#include "server/prepare/pages/simplify_piece.h"

#include <algorithm>

#include "server/prepare/pages/cluster_vertices.h"
#include "server/prepare/pages/collapse_edges.h"
#include "server/prepare/pages/kept_border.h"

namespace burnish {

namespace {

constexpr double kTrianglesPerCollapse = 2;
constexpr double kCollapsedPart = 0.6;  // of the vertices inside; half a usual page takes 0.54
constexpr int kTries = 4;  // each locks more; a piece that still loses its border stays as it is

// Locks all corners of the triangles around these vertices: such triangles stay.
void lock_around(const std::vector<uint32_t>& vertices, PagePiece& piece) {
  std::vector<uint8_t> is_centre(piece.vertices.size());
  for (const uint32_t v : vertices) is_centre[v] = 1;
  for (const Triangle& t : piece.triangles)
    if (is_centre[t[0]] || is_centre[t[1]] || is_centre[t[2]])
      for (const uint32_t v : t) piece.locked[v] = 1;
}

size_t triangles_wanted(const PagePiece& piece, SimplifyBy by) {
  const size_t triangles = piece.triangles.size(), half = std::max<size_t>(triangles / 2, 1);
  if (by != SimplifyBy::kCollapse) return half;
  const auto inside = static_cast<double>(std::ranges::count(piece.locked, 0));
  const auto spared = static_cast<size_t>(kTrianglesPerCollapse * kCollapsedPart * inside);
  return std::max(half, triangles - std::min(spared, triangles));
}

SimplePiece simplify_once(const PagePiece& piece, SimplifyBy by, size_t wanted) {
  if (by == SimplifyBy::kCluster) return cluster_vertices(piece, wanted);
  return collapse_edges(piece, wanted);
}

}  // namespace

SimplePiece simplify_piece(const PagePiece& piece, SimplifyBy by) {
  if (by == SimplifyBy::kKeep) return {piece.triangles};
  const size_t wanted = triangles_wanted(piece, by);
  if (by == SimplifyBy::kDrop) return drop_small_triangles(piece, wanted);
  const KeptBorder border(piece);
  PagePiece locked = piece;
  for (int i = 0; i < kTries; ++i) {
    SimplePiece simple = simplify_once(locked, by, wanted);
    const std::vector<uint32_t> lost = border.find_lost(simple.triangles);
    if (lost.empty() && !simple.triangles.empty()) return simple;
    if (lost.empty()) break;
    lock_around(lost, locked);
  }
  return {piece.triangles};
}

}  // namespace burnish
