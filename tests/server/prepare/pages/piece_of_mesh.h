#pragma once

#include <functional>

#include "common/mesh/triangle_mesh.h"
#include "server/prepare/pages/page_piece.h"

namespace burnish {

/// A whole mesh as one piece; `is_locked` tells which vertices must stay.
inline PagePiece piece_of(const TriangleMesh& mesh,
                          const std::function<bool(const Vec3d&)>& is_locked) {
  PagePiece piece;
  piece.triangles = mesh.triangles;
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    piece.vertices.push_back(v);
    piece.positions.push_back(mesh.vertices[v].cast<float>());
    piece.locked.push_back(is_locked(mesh.vertices[v]));
  }
  return piece;
}

}  // namespace burnish
