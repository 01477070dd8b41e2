#include "server/prepare/pages/page_piece.h"

#include "server/prepare/pages/local_vertices.h"

namespace burnish {

PagePiece make_piece(const CutLevel& level, std::span<const Vec3i> positions,
                     std::span<const uint8_t> shared, size_t page) {
  PagePiece piece;
  LocalVertices locals;
  piece.triangles.reserve(level.pages[page].size());
  for (const uint32_t t : level.pages[page]) {
    Triangle joined;
    for (int corner = 0; corner < 3; ++corner)
      joined[corner] = level.joined[level.triangles[t][corner]];
    if (joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0]) continue;
    piece.triangles.push_back(
        {locals.add(joined[0]), locals.add(joined[1]), locals.add(joined[2])});
  }
  piece.vertices.assign(locals.all().begin(), locals.all().end());
  for (const uint32_t v : piece.vertices) {
    piece.positions.push_back(positions[v].cast<float>());
    piece.locked.push_back(shared[v]);
  }
  return piece;
}

}  // namespace burnish
