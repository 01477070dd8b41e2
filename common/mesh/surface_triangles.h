#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/scratch_space.h"
#include "common/base/types.h"

namespace burnish {

/// Triangles whose vertices at one place count as one.
class TrianglesAtPlaces {
 public:
  /// `place`: per vertex, the least vertex at its place. Empty: the triangles have no others.
  TrianglesAtPlaces(std::span<const Triangle> triangles, std::span<const uint32_t> place)
      : triangles_(triangles), place_(place) {}

  size_t size() const { return triangles_.size(); }
  Triangle operator[](size_t t) const {
    const Triangle& own = triangles_[t];
    return place_.empty() ? own : Triangle{place_[own[0]], place_[own[1]], place_[own[2]]};
  }

 private:
  std::span<const Triangle> triangles_;
  std::span<const uint32_t> place_;
};

/// The triangles that make up the surface: not those with two vertices at one place, and not a copy
/// of one before, whichever way it turns. A file with such triangles has the edges of one without.
class SurfaceTriangles {
 public:
  /// `vertices`: more than any index. Cost: linear time; scratch of 1 byte per triangle to keep, 4
  /// bytes per triangle and 8 per vertex besides, which lies in `space`. Throws: WorkCancelled.
  SurfaceTriangles(const TrianglesAtPlaces& triangles, size_t vertices,
                   const ScratchSpace& space = {}, const LoopPart& part = kUnheardLoop);

  size_t size() const { return is_surface_.size(); }
  bool operator[](size_t triangle) const { return is_surface_[triangle] != 0; }

 private:
  ScratchArray<uint8_t> is_surface_;
};

}  // namespace burnish
