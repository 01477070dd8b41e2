#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Rounds a wished number of lattice lines to an integer of at least `least`.
inline int lattice_size(double wish, int least) {
  return std::max(least, static_cast<int>(std::lround(wish)));
}

/// Adds the quad a b c d, counter-clockwise seen from outside, as two triangles that share a-c.
inline void add_quad(TriangleMesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Adds the quads of a lattice of vertices, stored row by row from index `first` on. Seen from
/// outside, columns run to the right and rows run up.
inline void add_lattice_quads(TriangleMesh& mesh, uint32_t first, int columns, int rows) {
  for (int row = 0; row + 1 < rows; ++row)
    for (int column = 0; column + 1 < columns; ++column) {
      const uint32_t a = first + static_cast<uint32_t>(row) * columns + column;
      add_quad(mesh, a, a + 1, a + columns + 1, a + columns);
    }
}

}  // namespace burnish
