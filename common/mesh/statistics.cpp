#include "common/mesh/statistics.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

#include "common/base/scratch_array.h"
#include "common/mesh/components.h"
#include "common/mesh/joined_mesh.h"

namespace burnish {
namespace {

/// Calls visit(a, b) once for each edge of the triangle. A triangle has three edges, one if it
/// repeats a vertex, none if all three vertices are the same.
template <typename Visit>
void for_each_edge(const Triangle& triangle, const Visit& visit) {
  const auto& [a, b, c] = triangle;
  if (a != b) visit(a, b);
  if (b != c && c != a) visit(b, c);
  if (c != a && a != b && b != c) visit(c, a);
}

/// The edges of all triangles: upper ends, grouped by lower end and sorted in each group.
struct EdgeEnds {
  ScratchArray<uint64_t> first;  ///< per lower end, and one past the last
  ScratchArray<uint32_t> upper;
};

EdgeEnds collect_edges(const MeshView& mesh, const ScratchSpace& space) {
  EdgeEnds edges;
  edges.first = ScratchArray<uint64_t>(space, mesh.vertices.size() + 1);
  for (const Triangle& triangle : mesh.triangles)
    for_each_edge(triangle, [&](uint32_t a, uint32_t b) { ++edges.first[std::min(a, b)]; });
  std::exclusive_scan(edges.first.begin(), edges.first.end(), edges.first.begin(), uint64_t{0});
  edges.upper = ScratchArray<uint32_t>(space, edges.first.back());
  for (const Triangle& triangle : mesh.triangles)
    for_each_edge(triangle, [&](uint32_t a, uint32_t b) {
      edges.upper[edges.first[std::min(a, b)]++] = std::max(a, b);
    });
  // Each entry is now at its group's end, where the next group starts.
  std::rotate(edges.first.begin(), edges.first.end() - 1, edges.first.end());
  edges.first[0] = 0;
#pragma omp parallel for schedule(dynamic, 4096)
  for (size_t v = 0; v < mesh.vertices.size(); ++v)
    std::sort(edges.upper.begin() + edges.first[v], edges.upper.begin() + edges.first[v + 1]);
  return edges;
}

void count_edges(const MeshView& mesh, const ScratchSpace& space, MeshStatistics& statistics) {
  const EdgeEnds edges = collect_edges(mesh, space);
  uint64_t count = 0;
  double length = 0;
  for (size_t lower = 0; lower < mesh.vertices.size(); ++lower)
    for (uint64_t i = edges.first[lower]; i < edges.first[lower + 1];) {
      const uint32_t upper = edges.upper[i];
      uint64_t triangles = 0;
      for (; i < edges.first[lower + 1] && edges.upper[i] == upper; ++i) ++triangles;
      ++count;
      length += (mesh.vertices[upper] - mesh.vertices[lower]).norm();
      statistics.boundary_edges += triangles == 1;
      statistics.non_manifold_edges += triangles >= 3;
    }
  if (count > 0) statistics.mean_edge_length = length / static_cast<double>(count);
}

std::vector<bool> referenced_vertices(const MeshView& mesh) {
  std::vector<bool> referenced(mesh.vertices.size(), false);
  for (const Triangle& triangle : mesh.triangles)
    for (uint32_t v : triangle) referenced[v] = true;
  return referenced;
}

/// A component of the joined mesh is counted at its root, which is the least vertex of its places.
void count_vertices(const MeshView& mesh, const MeshView& joined, const ScratchSpace& space,
                    MeshStatistics& statistics) {
  ScratchArray<int32_t> roots(space, mesh.vertices.size());
  find_component_roots(joined.triangles, roots);
  const std::vector<bool> referenced = referenced_vertices(mesh);
  const std::vector<bool> is_corner = referenced_vertices(joined);
  statistics.box_min.setConstant(std::numeric_limits<double>::infinity());
  statistics.box_max.setConstant(-std::numeric_limits<double>::infinity());
  for (uint32_t v = 0; v < mesh.vertices.size(); ++v) {
    statistics.components += is_corner[v] && roots[v] == static_cast<int32_t>(v);
    if (!referenced[v]) {
      ++statistics.unreferenced_vertices;
      continue;
    }
    statistics.box_min = statistics.box_min.cwiseMin(mesh.vertices[v]);
    statistics.box_max = statistics.box_max.cwiseMax(mesh.vertices[v]);
  }
}

/// Sums the volume around the centre of the box: coordinates of surveys, far from the origin, would
/// cancel. Needs: the box.
void measure_triangles(const MeshView& mesh, MeshStatistics& statistics) {
  const Vec3d centre = statistics.box_min / 2 + statistics.box_max / 2;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3d& a = mesh.vertices[triangle[0]];
    const Vec3d twice_area = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
    statistics.zero_area_triangles += twice_area.isZero(0);
    statistics.area += twice_area.norm() / 2;
    statistics.signed_volume += (a - centre).dot(twice_area) / 6;
  }
}

}  // namespace

MeshStatistics compute_statistics(const MeshView& mesh, const MeshView& joined,
                                  const ScratchSpace& space) {
  MeshStatistics statistics;
  statistics.vertices = mesh.vertices.size();
  statistics.triangles = mesh.triangles.size();
  count_edges(joined, space, statistics);
  count_vertices(mesh, joined, space, statistics);
  measure_triangles(mesh, statistics);
  return statistics;
}

MeshStatistics compute_statistics(const MeshView& mesh, const ScratchSpace& space) {
  return compute_statistics(mesh, JoinedMesh(mesh, space).view(), space);
}

}  // namespace burnish
