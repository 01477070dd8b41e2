#pragma once

#include <cstdint>
#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/scratch_space.h"
#include "common/mesh/surface_triangles.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A mesh whose vertices at one place count as one, with the triangles at each place. A place is
/// named by the least vertex there. Triangles that are no surface (see SurfaceTriangles) keep their
/// numbers, and are at no place.
class WeldedSurface {
 public:
  /// Needs: a valid mesh, whose arrays outlive this. Cost: near linear time; 12 bytes per triangle
  /// and 12 per vertex to keep, in `space`, and as much while it is made. Throws: WorkCancelled,
  /// std::bad_alloc.
  explicit WeldedSurface(const MeshView& mesh, const ScratchSpace& space = {},
                         const LoopPart& part = kUnheardLoop);

  const MeshView& mesh() const { return mesh_; }
  size_t triangle_count() const { return mesh_.triangles.size(); }
  size_t vertex_count() const { return mesh_.vertices.size(); }

  /// Returns the place of a vertex: the least vertex at the same place.
  uint32_t place(size_t vertex) const { return place_[vertex]; }
  std::span<const uint32_t> places() const { return {place_.data(), place_.size()}; }
  /// Returns the places of a triangle's corners.
  const Triangle& triangle(size_t t) const { return triangles_[t]; }
  std::span<const Triangle> triangles() const { return triangles_; }
  bool is_surface(size_t t) const { return is_surface_[t]; }

  /// Returns the triangles of the surface at a place, ascending. Empty for vertices that are not
  /// the least at their place.
  std::span<const uint32_t> fan(size_t place) const {
    return {fans_.data() + fan_start_[place], fans_.data() + fan_start_[place + 1]};
  }
  /// One per vertex and one past the last, into fans().
  const uint64_t* fan_starts() const { return fan_start_.data(); }
  const uint32_t* fans() const { return fans_.data(); }
  uint64_t incidence_count() const { return fans_.size(); }
  /// Returns how many triangles make up the surface.
  uint64_t surface_count() const { return fans_.size() / 3; }

 private:
  void join(const ScratchSpace& space, const LoopPart& part);
  void collect_fans(const ScratchSpace& space, const LoopPart& part);

  MeshView mesh_;
  ScratchArray<uint32_t> place_;
  ScratchArray<Triangle> joined_;  // empty if no vertices meet
  std::span<const Triangle> triangles_;
  SurfaceTriangles is_surface_;
  ScratchArray<uint64_t> fan_start_;  // per vertex, and one past the last
  ScratchArray<uint32_t> fans_;
};

/// Returns the corners of a triangle of the mesh.
inline std::array<Vec3d, 3> corners_of(const MeshView& mesh, size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

}  // namespace burnish
