#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/base/scratch_array.h"
#include "common/base/types.h"
#include "common/mesh/triangle_mesh.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// A triangle of a scan, found by its places. Its corner (k + turn) % 3 is corner k of what was
/// looked for.
struct FoundTriangle {
  uint32_t triangle = 0;
  int turn = 0;
};

/// Finds the triangles of a scan that the pages of level 0 show. Pages keep places and orientation
/// of a triangle, and neither its number nor its first corner. Memory: 28 bytes a triangle and 12 a
/// vertex while it is made, 16 and 12 later.
class TriangleFinder {
 public:
  /// Needs: a valid mesh, which outlives this; the grid of its pages.
  TriangleFinder(const MeshView& mesh, const PageGrid& grid, const ScratchSpace& space);

  /// Returns the first triangle with these places. Nothing if it has corners that the pages have
  /// joined with others at another step. Threads may call it at the same time.
  std::optional<FoundTriangle> find(const std::array<Vec3i, 3>& places) const;

 private:
  struct Entry {
    uint64_t hash;
    uint32_t triangle;
  };
  std::array<Vec3i, 3> places_of(uint32_t triangle) const;

  std::span<const Triangle> triangles_;
  ScratchArray<Vec3i> places_;  // per vertex, steps
  ScratchArray<Entry> sorted_;  // by hash, then triangle
};

}  // namespace burnish
