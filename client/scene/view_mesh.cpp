#include "client/scene/view_mesh.h"

#include "client/scene/mesh_normals.h"
#include "client/scene/ridges.h"

namespace burnish {

static Eigen::AlignedBox3d referenced_box(std::span<const Vec3d> vertices,
                                          std::span<const Triangle> triangles) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : triangles)
    for (uint32_t v : triangle) box.extend(vertices[v]);
  return box;
}

static ViewMesh make_drawn(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  ViewMesh view;
  view.box = referenced_box(vertices, triangles);
  view.positions.reserve(vertices.size());
  const Vec3d centre = view.box.center();
  const double unit = view.unit();
  for (const Vec3d& vertex : vertices)
    view.positions.push_back(((vertex - centre) / unit).cast<float>());
  view.normals = vertex_normals(vertices, triangles);
  view.ridges = vertex_ridges(view.positions, view.normals, triangles);
  view.triangles.assign(triangles.begin(), triangles.end());
  return view;
}

ViewMesh make_view_mesh(const TriangleMesh& mesh) {
  return make_drawn(mesh.vertices, mesh.triangles);
}

ViewMesh make_view_mesh(const View& view) {
  ViewMesh mesh = make_drawn(view.vertices, view.triangles);
  mesh.points = view.points;
  mesh.cell_corners = view.grid.cell_corners;
  mesh.corner_count = view.grid.corner_count();
  mesh.cell_size = static_cast<float>(view.frame.cell_size / mesh.unit());
  return mesh;
}

}  // namespace burnish
