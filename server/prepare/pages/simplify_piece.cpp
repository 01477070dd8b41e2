#include "server/prepare/pages/simplify_piece.h"

#include <algorithm>

#include "server/prepare/pages/cluster_vertices.h"
#include "server/prepare/pages/collapse_edges.h"
#include "server/prepare/pages/kept_border.h"

namespace burnish {

namespace {

constexpr int kTries = 4;  // each locks more; a piece that still loses its border stays as it is

// Locks all corners of the triangles around these vertices: such triangles stay.
void lock_around(const std::vector<uint32_t>& vertices, PagePiece& piece) {
  std::vector<uint8_t> is_centre(piece.vertices.size());
  for (const uint32_t v : vertices) is_centre[v] = 1;
  for (const Triangle& t : piece.triangles)
    if (is_centre[t[0]] || is_centre[t[1]] || is_centre[t[2]])
      for (const uint32_t v : t) piece.locked[v] = 1;
}

SimplePiece simplify_once(const PagePiece& piece, SimplifyBy by, size_t triangles_wanted) {
  if (by == SimplifyBy::kCollapse) return collapse_edges(piece, triangles_wanted);
  return cluster_vertices(piece, triangles_wanted);
}

}  // namespace

SimplePiece simplify_piece(const PagePiece& piece, SimplifyBy by) {
  const size_t wanted = std::max<size_t>(piece.triangles.size() / 2, 1);
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
