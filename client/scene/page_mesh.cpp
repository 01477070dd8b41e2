#include "client/scene/page_mesh.h"

#include "client/scene/page_normals.h"
#include "client/scene/ridges.h"
#include "common/base/check.h"

namespace burnish {

// All steps are exact: the numerator has 24 bits and the number of steps is a power of two.
static Vec3f position_of(const Vec3i& lattice, int steps) {
  return (2 * lattice + Vec3i::Constant(1 - steps)).cast<float>() / static_cast<float>(steps);
}

static Vec3f unit_or(const Vec3f& sum, const Vec3f& otherwise) {
  const float length = sum.norm();
  return length > 0 ? Vec3f(sum / length) : otherwise;
}

PageMesh make_page_mesh(const Page& page, const PageGrid& grid) {
  PageMesh mesh;
  mesh.triangles = page.triangles;
  mesh.colours = page.colours;
  mesh.positions.reserve(page.positions.size());
  for (const Vec3i& lattice : page.positions)
    mesh.positions.push_back(position_of(lattice, grid.steps()));
  mesh.border_vertices = page.border_vertices;
  mesh.normals = page.normals;
  const std::vector<Vec3f> sums = sum_corner_normals(mesh.positions, mesh.triangles);
  const size_t carried = page.normals.size();
  mesh.own_sums.assign(sums.begin(), sums.begin() + static_cast<ptrdiff_t>(carried));
  for (size_t v = carried; v < sums.size(); ++v)
    mesh.normals.push_back(unit_or(sums[v], Vec3f::UnitZ()));
  mesh.ridges = vertex_ridges(mesh.positions, mesh.normals, mesh.triangles);
  return mesh;
}

MovedPage displace(const PageMesh& mesh, std::span<const Vec3f> displacements, float cell_size) {
  BURNISH_CHECK(displacements.size() == mesh.positions.size(), "one displacement per vertex");
  MovedPage moved;
  moved.positions.resize(mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    moved.positions[v] = mesh.positions[v] + cell_size * displacements[v];
  moved.normals = sum_corner_normals(moved.positions, mesh.triangles);
  const size_t carried = mesh.own_sums.size();
  for (size_t v = 0; v < carried; ++v)
    moved.normals[v] = turned_normal(mesh.normals[v], mesh.own_sums[v], moved.normals[v]);
  for (size_t v = carried; v < moved.normals.size(); ++v)
    moved.normals[v] = unit_or(moved.normals[v], mesh.normals[v]);
  return moved;
}

}  // namespace burnish
