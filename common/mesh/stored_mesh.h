#pragma once

#include "common/base/scratch_array.h"
#include "common/base/scratch_vector.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

/// A mesh in scratch space.
struct StoredMesh {
  StoredMesh() = default;
  StoredMesh(const MeshView& mesh, const ScratchSpace& space);

  MeshView view() const;

  ScratchArray<Vec3d> vertices;
  ScratchArray<Triangle> triangles;
  ScratchArray<Rgba8> colours;
  bool has_double_positions = false;
};

/// A mesh in scratch space while it is read.
struct GrowingMesh {
  explicit GrowingMesh(const ScratchSpace& space_of_all)
      : space(space_of_all), vertices(space), triangles(space), colours(space) {}

  StoredMesh take();

  ScratchSpace space;
  ScratchVector<Vec3d> vertices;
  ScratchVector<Triangle> triangles;
  ScratchVector<Rgba8> colours;
  bool has_double_positions = false;
};

/// Returns where a reader's own arrays lie, beside those of its mesh.
inline ScratchSpace space_beside(const GrowingMesh& mesh) {
  return mesh.space;
}
inline ScratchSpace space_beside(const TriangleMesh&) {
  return {};
}

}  // namespace burnish
