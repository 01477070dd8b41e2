#include "client/scene/thinned_triangles.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <Eigen/Geometry>

#include "common/grid/morton.h"

namespace burnish {

static constexpr double kCellsAcrossMax = 1 << 20;  // of a Morton key
static constexpr double kGrowth = 1.1;

static double area_of(const TriangleMesh& mesh) {
  double twice = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    twice +=
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  return twice / 2;
}

// Returns for each vertex the first one in its cell.
static std::vector<uint32_t> first_in_cells(const std::vector<Vec3d>& vertices, const Vec3d& low,
                                            double cell) {
  std::unordered_map<uint64_t, uint32_t> first;
  std::vector<uint32_t> stands_for(vertices.size());
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    const Vec3i at = ((vertices[v] - low) / cell).cast<int>();
    stands_for[v] = first.try_emplace(morton_key(at), v).first->second;
  }
  return stands_for;
}

static std::vector<Triangle> clustered(const TriangleMesh& mesh, const Vec3d& low, double cell) {
  const std::vector<uint32_t> stands_for = first_in_cells(mesh.vertices, low, cell);
  std::vector<Triangle> triangles;
  for (const auto& [i, j, k] : mesh.triangles) {
    const uint32_t a = stands_for[i], b = stands_for[j], c = stands_for[k];
    if (a != b && b != c && c != a) triangles.push_back({a, b, c});
  }
  return triangles;
}

std::vector<Triangle> thinned_triangles(const TriangleMesh& mesh, uint64_t triangles_max) {
  if (mesh.triangles.size() <= triangles_max) return mesh.triangles;
  Eigen::AlignedBox3d box;
  for (const Vec3d& vertex : mesh.vertices) box.extend(vertex);
  // A cell of the surface gives two triangles.
  double cell = std::sqrt(2 * area_of(mesh) / static_cast<double>(triangles_max));
  cell = std::max(cell, box.sizes().maxCoeff() / kCellsAcrossMax);
  for (;;) {
    std::vector<Triangle> triangles = clustered(mesh, box.min(), cell);
    if (triangles.size() <= triangles_max) return triangles;
    const double excess = static_cast<double>(triangles.size()) / double(triangles_max);
    cell *= std::max(kGrowth, std::sqrt(excess));
  }
}

}  // namespace burnish
