#pragma once

#include <cstdint>
#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/denoise/welded_surface.h"

namespace burnish {

/// At a place of more triangles than these, all of them are not each other's ring: a file may have
/// all its triangles at one place, and pairs grow as the square. Neighbours there meet at the other
/// end of their common edge.
inline constexpr size_t kFanTrianglesMax = 64;
inline constexpr size_t kRingTrianglesMax = 3 * (kFanTrianglesMax - 1);

/// The ring of each triangle: the triangles of the surface that share a place with it, without
/// itself, in compressed rows. A row has the order of its corners and of their fans.
class TriangleRings {
 public:
  /// Cost: linear time; 8 bytes per triangle and 4 per pair, about 12 pairs a triangle, in `space`.
  /// Throws: WorkCancelled, std::bad_alloc.
  explicit TriangleRings(const WeldedSurface& surface, const ScratchSpace& space = {},
                         const LoopPart& part = kUnheardLoop);

  size_t size() const { return start_.size() - 1; }
  uint64_t pair_count() const { return triangle_.size(); }
  std::span<const uint32_t> operator[](size_t t) const {
    return {triangle_.data() + start_[t], triangle_.data() + start_[t + 1]};
  }
  /// One per triangle and one past the last, into triangles().
  const uint64_t* starts() const { return start_.data(); }
  const uint32_t* triangles() const { return triangle_.data(); }

 private:
  ScratchArray<uint64_t> start_;
  ScratchArray<uint32_t> triangle_;
};

}  // namespace burnish
