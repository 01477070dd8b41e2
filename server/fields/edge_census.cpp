#include "server/fields/edge_census.h"

#include <algorithm>

#include "common/base/groups.h"
#include "common/mesh/joined_mesh.h"
#include "common/mesh/surface_triangles.h"

namespace burnish {

/// The edges by their lesser end. An edge is its greater end, times two, plus one if it comes from
/// there.
using Edges = Groups<uint32_t, int64_t>;

static Edges edges_by_lesser_end(const TrianglesAtPlaces& triangles, size_t vertices) {
  const SurfaceTriangles surface(triangles, vertices);
  Edges edges = group_by<uint32_t, int64_t>(vertices, [&](const auto& add) {
    for (size_t t = 0; t < triangles.size(); ++t) {
      if (!surface[t]) continue;
      const Triangle at = triangles[t];
      for (int side = 0; side < 3; ++side) {
        const uint32_t from = at[side], to = at[(side + 1) % 3];
        add(std::min(from, to), std::max(from, to) << 1 | uint32_t{from > to});
      }
    }
  });
#pragma omp parallel for schedule(dynamic, 4096)
  for (int64_t v = 0; v < static_cast<int64_t>(vertices); ++v)
    std::sort(edges.item.begin() + edges.start[v], edges.item.begin() + edges.start[v + 1]);
  return edges;
}

/// Counts the edges that end at `least`.
static void count_edges(uint32_t least, std::span<const uint32_t> edges, EdgeCensus& census) {
  for (size_t i = 0; i < edges.size();) {
    size_t end = i, backward = 0;
    for (; end < edges.size() && edges[end] >> 1 == edges[i] >> 1; ++end)
      backward += edges[end] & 1;
    census.is_closed &= 2 * backward == end - i;
    const uint32_t greatest = edges[i] >> 1;
    if (end - i == 1)
      census.rims.push_back(backward ? RimEdge{greatest, least} : RimEdge{least, greatest});
    i = end;
  }
}

EdgeCensus take_edge_census(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  EdgeCensus census;
  census.place = least_at_places(vertices);
  const Edges edges =
      edges_by_lesser_end({triangles, {census.place.data(), vertices.size()}}, vertices.size());
  census.is_closed = !edges.item.empty();
  for (size_t v = 0; v < edges.count(); ++v)
    count_edges(static_cast<uint32_t>(v), edges[v], census);
  return census;
}

uint64_t edge_census_bytes(uint64_t vertices, uint64_t triangles, uint64_t rims) {
  constexpr uint64_t kGrowth = 2;  // the rims grow by themselves
  const uint64_t edges = 3 * triangles;
  return vertices * (sizeof(uint32_t) + 2 * sizeof(uint64_t)) + triangles +
         edges * sizeof(uint32_t) + rims * kGrowth * sizeof(RimEdge);
}

}  // namespace burnish
