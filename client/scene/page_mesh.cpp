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
  const std::vector<Vec3f> sums = sum_corner_normals(mesh.positions, mesh.triangles);
  mesh.normals = page.normals;
  for (size_t v = 0; v < page.normals.size(); ++v)
    mesh.own_normals.push_back(unit_or(sums[v], Vec3f::Zero()));
  for (size_t v = page.normals.size(); v < sums.size(); ++v)
    mesh.normals.push_back(unit_or(sums[v], Vec3f::UnitZ()));
  mesh.ridges = vertex_ridges(mesh.positions, mesh.normals, mesh.triangles);
  return mesh;
}

static Vec3f displaced_normal(const PageMesh& mesh, size_t vertex, const Vec3f& sum) {
  const Vec3f& still = mesh.normals[vertex];
  const float length = sum.norm();
  if (!(length > 0)) return still;
  if (vertex >= mesh.own_normals.size()) return sum / length;
  const Vec3f& own = mesh.own_normals[vertex];
  return own.isZero(0) ? still : turned_normal(still, own, sum / length);
}

MovedPage displace(const PageMesh& mesh, std::span<const Vec3f> displacements, float cell_size) {
  BURNISH_CHECK(displacements.size() == mesh.positions.size(), "one displacement per vertex");
  MovedPage moved;
  moved.positions.resize(mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    moved.positions[v] = mesh.positions[v] + cell_size * displacements[v];
  moved.normals = sum_corner_normals(moved.positions, mesh.triangles);
  for (size_t v = 0; v < moved.normals.size(); ++v)
    moved.normals[v] = displaced_normal(mesh, v, moved.normals[v]);
  moved.ridges = vertex_ridges(moved.positions, moved.normals, mesh.triangles);
  return moved;
}

}  // namespace burnish
