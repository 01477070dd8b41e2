#include "common/mesh/stored_mesh.h"

namespace burnish {

StoredMesh::StoredMesh(const MeshView& mesh, const ScratchSpace& space)
    : vertices(copy_to(space, mesh.vertices)),
      triangles(copy_to(space, mesh.triangles)),
      colours(copy_to(space, mesh.colours)),
      has_double_positions(mesh.has_double_positions) {}

MeshView StoredMesh::view() const {
  MeshView mesh;
  mesh.vertices = vertices;
  mesh.triangles = triangles;
  mesh.colours = colours;
  mesh.has_double_positions = has_double_positions;
  return mesh;
}

StoredMesh GrowingMesh::take() {
  StoredMesh mesh;
  mesh.vertices = vertices.take();
  mesh.triangles = triangles.take();
  mesh.colours = colours.take();
  mesh.has_double_positions = has_double_positions;
  return mesh;
}

}  // namespace burnish
