#pragma once

#include <cstdint>
#include <span>

#include "common/base/heard_loop.h"
#include "common/base/scratch_array.h"
#include "common/base/scratch_space.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// Returns for each vertex the least vertex at its place. Vertices whose coordinates are not
/// numbers are at no place of others. Cost: linear time; scratch of 13 bytes per vertex, which lies
/// in `space`. Throws: WorkCancelled.
ScratchArray<uint32_t> least_at_places(std::span<const Vec3d> vertices,
                                       const ScratchSpace& space = {},
                                       const LoopPart& part = kUnheardLoop);

/// A mesh whose vertices at one place count as one: the surface is what positions say, however its
/// file shares vertices. Seams of textures and soups of triangles hang together.
class JoinedMesh {
 public:
  /// Needs: the mesh's arrays outlive this. Cost: as least_at_places(); 12 bytes per triangle to
  /// keep if vertices meet. Throws: WorkCancelled.
  JoinedMesh(const MeshView& mesh, const ScratchSpace& space, const LoopPart& part = kUnheardLoop);

  /// The mesh with triangles of the least vertices at their places, in the same order.
  const MeshView& view() const { return view_; }
  /// Returns whether several vertices are at one place.
  bool has_joins() const { return !triangles_.empty(); }

 private:
  ScratchArray<Triangle> triangles_;  // empty if no vertices meet
  MeshView view_;
};

}  // namespace burnish
