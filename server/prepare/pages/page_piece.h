#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "server/prepare/pages/shared_vertices.h"

namespace burnish {

/// The triangles of one page by themselves, ready to be simplified. Vertices of one place are
/// joined, and triangles that lose their area by that are left out.
struct PagePiece {
  std::vector<uint32_t> vertices;   ///< of the scan, by the piece's own numbers
  std::vector<Vec3f> positions;     ///< per vertex, steps of the grid: exact
  std::vector<uint8_t> locked;      ///< per vertex, 1: must stay
  std::vector<Triangle> triangles;  ///< the piece's own numbers
};

/// Fewer triangles in place of a piece's.
struct SimplePiece {
  std::vector<Triangle> triangles;  ///< the piece's own numbers
  float error = 0;                  ///< steps: how far the surface has moved, about
};

/// Takes one page out of its level. `shared` is find_shared_vertices() of the level.
PagePiece make_piece(const CutLevel& level, std::span<const Vec3i> positions,
                     std::span<const uint8_t> shared, size_t page);

}  // namespace burnish
