#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/base/heard_loop.h"
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
/// of a triangle, and neither its number nor its first corner. Pages of earlier releases put
/// vertices of one place on different sides of a plane of the grid. So vertices are compared as if
/// all lay above. Memory: 28 bytes a triangle and 40 a vertex while it is made, 16 and 36
/// later.
class TriangleFinder {
 public:
  /// Needs: a valid mesh, which outlives this; the grid of its pages. Throws: WorkCancelled.
  TriangleFinder(const MeshView& mesh, const PageGrid& grid, const ScratchSpace& space,
                 const LoopPart& part = kUnheardLoop);

  /// Returns the first triangle with these places, if there is one. Threads may call it at the same
  /// time.
  std::optional<FoundTriangle> find(const std::array<Vec3i, 3>& places) const;

 private:
  struct Entry {
    uint64_t hash;
    uint32_t triangle;
  };
  /// A place below a plane, and the one above that stands for it.
  struct Raised {
    Vec3i below;
    Vec3i above;
  };
  void raise_places(std::span<const uint8_t> below, const LoopPart& part);
  std::span<const Raised> raised(const Vec3i& place) const;
  std::array<Vec3i, 3> places_of(uint32_t triangle) const;
  std::optional<FoundTriangle> find_raised(const std::array<Vec3i, 3>& places) const;

  std::span<const Triangle> triangles_;
  ScratchArray<Vec3i> places_;  // per vertex, steps, raised
  std::vector<Raised> raised_;  // by the place below
  ScratchArray<Entry> sorted_;  // by hash, then triangle
};

}  // namespace burnish
