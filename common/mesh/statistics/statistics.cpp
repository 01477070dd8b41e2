#include "common/mesh/statistics/statistics.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "common/base/heard_groups.h"
#include "common/base/scratch_array.h"
#include "common/mesh/joined_mesh.h"
#include "common/mesh/statistics/components.h"
#include "common/mesh/statistics/heard_statistics.h"
#include "common/mesh/surface_triangles.h"

namespace burnish {
namespace {

/// Calls visit(lower, upper) for each edge of the surface.
template <typename Visit>
void for_each_edge(const LoopPart& part, std::span<const Triangle> triangles,
                   const SurfaceTriangles& surface, const Visit& visit) {
  for_each_heard(part, triangles.size(), [&](size_t t) {
    if (!surface[t]) return;
    const auto& [a, b, c] = triangles[t];
    visit(std::min(a, b), std::max(a, b));
    visit(std::min(b, c), std::max(b, c));
    visit(std::min(c, a), std::max(c, a));
  });
}

/// The edges of all triangles: upper ends, grouped by lower end and sorted in each group.
struct EdgeEnds {
  ScratchArray<uint64_t> first;  ///< per lower end, and one past the last
  ScratchArray<uint32_t> upper;
};

void sort_groups(EdgeEnds& edges, const LoopPart& part) {
  const auto group = [&](size_t v) {
    return std::span(edges.upper.begin() + edges.first[v],
                     edges.upper.begin() + edges.first[v + 1]);
  };
  for_each_group_heard(
      part, edges.first.size() - 1, [&](size_t v) { return group(v).size(); },
      [&](size_t v, const auto& sort) { sort(group(v), std::less<>()); });
}

EdgeEnds collect_edges(const MeshView& mesh, const ScratchSpace& space, const LoopPart& part) {
  const SurfaceTriangles surface({mesh.triangles, {}}, mesh.vertices.size(), space,
                                 part.of(0, 0.4));
  EdgeEnds edges;
  edges.first = ScratchArray<uint64_t>(space, mesh.vertices.size() + 1);
  for_each_edge(part.of(0.4, 0.5), mesh.triangles, surface,
                [&](uint32_t lower, uint32_t) { ++edges.first[lower]; });
  std::exclusive_scan(edges.first.begin(), edges.first.end(), edges.first.begin(), uint64_t{0});
  edges.upper = ScratchArray<uint32_t>(space, edges.first.back());
  for_each_edge(part.of(0.5, 0.7), mesh.triangles, surface,
                [&](uint32_t lower, uint32_t upper) { edges.upper[edges.first[lower]++] = upper; });
  // Each entry is now at its group's end, where the next group starts.
  std::rotate(edges.first.begin(), edges.first.end() - 1, edges.first.end());
  edges.first[0] = 0;
  sort_groups(edges, part.of(0.7, 1));
  return edges;
}

void count_edges(const MeshView& mesh, const ScratchSpace& space, const LoopPart& part,
                 MeshStatistics& statistics) {
  const EdgeEnds edges = collect_edges(mesh, space, part.of(0, 0.7));
  uint64_t count = 0;
  double length = 0;
  for_each_heard(part.of(0.7, 1), mesh.vertices.size(), [&](size_t lower) {
    for (uint64_t i = edges.first[lower]; i < edges.first[lower + 1];) {
      const uint32_t upper = edges.upper[i];
      uint64_t triangles = 0;
      for (; i < edges.first[lower + 1] && edges.upper[i] == upper; ++i) ++triangles;
      ++count;
      length += (mesh.vertices[upper] - mesh.vertices[lower]).norm();
      statistics.boundary_edges += triangles == 1;
      statistics.non_manifold_edges += triangles >= 3;
    }
  });
  if (count > 0) statistics.mean_edge_length = length / static_cast<double>(count);
}

std::vector<bool> referenced_vertices(const MeshView& mesh, const LoopPart& part) {
  std::vector<bool> referenced(mesh.vertices.size(), false);
  for_each_heard(part, mesh.triangles.size(), [&](size_t t) {
    for (uint32_t v : mesh.triangles[t]) referenced[v] = true;
  });
  return referenced;
}

/// A component of the joined mesh is counted at its root, which is the least vertex of its places.
void count_vertices(const MeshView& mesh, const MeshView& joined, const ScratchSpace& space,
                    const LoopPart& part, MeshStatistics& statistics) {
  ScratchArray<int32_t> roots(space, mesh.vertices.size());
  find_component_roots(joined.triangles, roots, part.of(0, 0.6));
  const std::vector<bool> referenced = referenced_vertices(mesh, part.of(0.6, 0.7));
  const std::vector<bool> is_corner = referenced_vertices(joined, part.of(0.7, 0.8));
  statistics.box_min.setConstant(std::numeric_limits<double>::infinity());
  statistics.box_max.setConstant(-std::numeric_limits<double>::infinity());
  for_each_heard(part.of(0.8, 1), mesh.vertices.size(), [&](size_t v) {
    statistics.components += is_corner[v] && roots[v] == static_cast<int32_t>(v);
    if (!referenced[v]) {
      ++statistics.unreferenced_vertices;
      return;
    }
    statistics.box_min = statistics.box_min.cwiseMin(mesh.vertices[v]);
    statistics.box_max = statistics.box_max.cwiseMax(mesh.vertices[v]);
  });
}

/// Sums the volume around the centre of the box: coordinates of surveys, far from the origin, would
/// cancel. Needs: the box.
void measure_triangles(const MeshView& mesh, const LoopPart& part, MeshStatistics& statistics) {
  const Vec3d centre = statistics.box_min / 2 + statistics.box_max / 2;
  for_each_heard(part, mesh.triangles.size(), [&](size_t t) {
    const Triangle& triangle = mesh.triangles[t];
    const Vec3d& a = mesh.vertices[triangle[0]];
    const Vec3d twice_area = (mesh.vertices[triangle[1]] - a).cross(mesh.vertices[triangle[2]] - a);
    statistics.zero_area_triangles += twice_area.isZero(0);
    statistics.area += twice_area.norm() / 2;
    statistics.signed_volume += (a - centre).dot(twice_area) / 6;
  });
}

}  // namespace

MeshStatistics compute_statistics(const MeshView& mesh, const MeshView& joined,
                                  const ScratchSpace& space, const LoopPart& part) {
  MeshStatistics statistics;
  statistics.vertices = mesh.vertices.size();
  statistics.triangles = mesh.triangles.size();
  count_edges(joined, space, part.of(0, 0.6), statistics);
  count_vertices(mesh, joined, space, part.of(0.6, 0.9), statistics);
  measure_triangles(mesh, part.of(0.9, 1), statistics);
  return statistics;
}

MeshStatistics compute_statistics(const MeshView& mesh, const MeshView& joined,
                                  const ScratchSpace& space) {
  return compute_statistics(mesh, joined, space, kUnheardLoop);
}

MeshStatistics compute_statistics(const MeshView& mesh, const ScratchSpace& space) {
  return compute_statistics(mesh, space, kUnheardLoop);
}

MeshStatistics compute_statistics(const MeshView& mesh, const ScratchSpace& space,
                                  const LoopPart& part) {
  const JoinedMesh joined(mesh, space, part.of(0, 0.4));
  return compute_statistics(mesh, joined.view(), space, part.of(0.4, 1));
}

}  // namespace burnish
