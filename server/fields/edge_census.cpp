#include "server/fields/edge_census.h"

#include <algorithm>
#include <array>

#include "common/base/groups.h"
#include "common/mesh/joined_mesh.h"

namespace burnish {

/// Calls visit(from, to) for the edges of all triangles with three places.
template <typename Visit>
static void for_each_edge(std::span<const Triangle> triangles, const ScratchArray<uint32_t>& place,
                          const Visit& visit) {
  for (const Triangle& triangle : triangles) {
    const std::array at = {place[triangle[0]], place[triangle[1]], place[triangle[2]]};
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
    for (int side = 0; side < 3; ++side) visit(at[side], at[(side + 1) % 3]);
  }
}

/// The edges by their lesser end. An edge is its greater end, times two, plus one if it comes from
/// there.
using Edges = Groups<uint32_t, int64_t>;

static Edges edges_by_lesser_end(std::span<const Triangle> triangles,
                                 const ScratchArray<uint32_t>& place) {
  Edges edges = group_by<uint32_t, int64_t>(place.size(), [&](const auto& add) {
    for_each_edge(triangles, place, [&](uint32_t from, uint32_t to) {
      add(std::min(from, to), std::max(from, to) << 1 | uint32_t{from > to});
    });
  });
  const auto vertices = static_cast<int64_t>(place.size());
#pragma omp parallel for schedule(dynamic, 4096)
  for (int64_t v = 0; v < vertices; ++v)
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
  const Edges edges = edges_by_lesser_end(triangles, census.place);
  census.is_closed = !edges.item.empty();
  for (size_t v = 0; v < edges.count(); ++v)
    count_edges(static_cast<uint32_t>(v), edges[v], census);
  return census;
}

uint64_t edge_census_bytes(uint64_t vertices, uint64_t triangles, uint64_t rims) {
  constexpr uint64_t kGrowth = 2;  // the rims grow by themselves
  const uint64_t edges = 3 * triangles;
  return vertices * (sizeof(uint32_t) + 2 * sizeof(uint64_t)) + edges * sizeof(uint32_t) +
         rims * kGrowth * sizeof(RimEdge);
}

}  // namespace burnish
