#include "server/prepare/pages/collapse_edges.h"

#include <meshoptimizer.h>

namespace burnish {

namespace {

constexpr float kAnyError = 1;  // of the piece's extent: only the count decides

// Lists the positions, then those of the locked vertices again. meshoptimizer 0.18 takes vertices
// of one place for the sides of a seam, and locks them unless both sides have seam edges that meet.
// The second ones have no edges at all, so the first ones are locked. Debian's version has no
// option to lock single vertices, and its option to lock borders would lock the scan's own, where
// soup then gets stuck. collapse_edges_test tells when another version does otherwise.
std::vector<Vec3f> positions_with_locks(const PagePiece& piece) {
  std::vector<Vec3f> positions = piece.positions;
  for (size_t v = 0; v < piece.positions.size(); ++v)
    if (piece.locked[v]) positions.push_back(piece.positions[v]);
  return positions;
}

}  // namespace

SimplePiece collapse_edges(const PagePiece& piece, size_t triangles_wanted) {
  static_assert(sizeof(Triangle) == 3 * sizeof(unsigned int));
  SimplePiece simple;
  if (piece.triangles.empty()) return simple;
  const std::vector<Vec3f> positions = positions_with_locks(piece);
  simple.triangles.resize(piece.triangles.size());
  const size_t indices =
      meshopt_simplify(simple.triangles[0].data(), piece.triangles[0].data(),
                       3 * piece.triangles.size(), positions[0].data(), positions.size(),
                       sizeof(Vec3f), 3 * triangles_wanted, kAnyError, 0, &simple.error);
  simple.triangles.resize(indices / 3);
  simple.error *= meshopt_simplifyScale(positions[0].data(), positions.size(), sizeof(Vec3f));
  return simple;
}

}  // namespace burnish
