#include "tests/server/prepare/test_meshes.h"

#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace burnish {

static TriangleMesh icosahedron() {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  // Its faces are the triples at the shortest distance, facing outwards.
  for (uint32_t a = 0; a < 12; ++a)
    for (uint32_t b = a + 1; b < 12; ++b)
      for (uint32_t c = b + 1; c < 12; ++c) {
        const Vec3d &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        if ((p - q).norm() > 2.1 || (q - r).norm() > 2.1 || (r - p).norm() > 2.1) continue;
        const bool is_outward = (q - p).cross(r - p).dot(p) > 0;
        mesh.triangles.push_back(is_outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
  return mesh;
}

static void split(TriangleMesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> midpoints;
  const auto midpoint = [&](uint32_t a, uint32_t b) {
    const auto [it, is_new] =
        midpoints.try_emplace(std::minmax(a, b), static_cast<uint32_t>(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return it->second;
  };
  std::vector<Triangle> parts;
  for (const auto& [a, b, c] : mesh.triangles) {
    const uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
    parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move(parts);
}

TriangleMesh test_sphere(int level, double radius) {
  TriangleMesh mesh = icosahedron();
  for (int i = 0; i < level; ++i) {
    split(mesh);
    for (Vec3d& p : mesh.vertices) p.normalize();
  }
  for (Vec3d& p : mesh.vertices) p *= radius / p.norm();
  return mesh;
}

TriangleMesh test_patch(int side, const std::function<Vec3d(double, double)>& surface) {
  TriangleMesh mesh;
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i)
      mesh.vertices.push_back(
          surface(static_cast<double>(i) / side, static_cast<double>(j) / side));
  const auto index = [&](int i, int j) { return static_cast<uint32_t>(j * (side + 1) + i); };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  return mesh;
}

TriangleMesh test_cylinder(double radius, double height) {
  return test_patch(64, [=](double u, double v) {
    const double angle = 2 * std::numbers::pi * u;
    return Vec3d(radius * std::cos(angle), radius * std::sin(angle), height * v);
  });
}

MeshStatistics test_statistics(const TriangleMesh& mesh, bool is_closed) {
  MeshStatistics statistics;
  statistics.boundary_edges = is_closed ? 0 : 1;
  statistics.box_min = statistics.box_max = mesh.vertices[mesh.triangles[0][0]];
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3d &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
    statistics.signed_volume += p.dot(q.cross(r)) / 6;
    statistics.box_min = statistics.box_min.cwiseMin(p).cwiseMin(q).cwiseMin(r);
    statistics.box_max = statistics.box_max.cwiseMax(p).cwiseMax(q).cwiseMax(r);
  }
  return statistics;
}

TriangleMesh inside_out(TriangleMesh mesh) {
  for (Triangle& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace burnish
