#include "server/fields/edge_census.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

#include "common/base/groups.h"

namespace burnish {

static uint32_t hash_of(const Vec3d& place) {
  uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double value = place[axis] + 0.0;  // minus zero is at the place of zero
    hash = (hash ^ std::bit_cast<uint64_t>(value)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return static_cast<uint32_t>(hash);
}

/// Vertices of a bucket. Its bounds then fit into a core's cache.
static constexpr size_t kVerticesPerBucket = 16;

/// Enters the first of vertices of one hash at each place. Sorts, because they may be all vertices.
static void find_first(std::span<const Vec3d> vertices, std::span<uint64_t> same_hash,
                       std::vector<uint32_t>& first) {
  const auto vertex = [](uint64_t hashed) { return static_cast<uint32_t>(hashed); };
  const auto key = [&](uint64_t hashed) {
    const Vec3d& at = vertices[vertex(hashed)];
    return std::tuple(at.x(), at.y(), at.z(), vertex(hashed));
  };
  if (same_hash.size() > 1) std::ranges::sort(same_hash, {}, key);
  for (size_t i = 0; i < same_hash.size(); ++i) {
    const uint32_t v = vertex(same_hash[i]);
    const bool is_same = i > 0 && vertices[v] == vertices[vertex(same_hash[i - 1])];
    first[v] = is_same ? first[vertex(same_hash[i - 1])] : v;
  }
}

static void find_first_in_bucket(std::span<const Vec3d> vertices, std::span<uint64_t> bucket,
                                 std::vector<uint32_t>& first) {
  std::ranges::sort(bucket);
  for (size_t i = 0; i < bucket.size();) {
    size_t end = i + 1;
    while (end < bucket.size() && bucket[end] >> 32 == bucket[i] >> 32) ++end;
    find_first(vertices, bucket.subspan(i, end - i), first);
    i = end;
  }
}

/// Returns for each vertex the least vertex at its place.
static std::vector<uint32_t> first_at_place(std::span<const Vec3d> vertices) {
  const size_t bucket_count = vertices.size() / kVerticesPerBucket + 1;
  auto buckets = group_by<uint64_t, int64_t>(bucket_count, [&](const auto& add) {
    for (size_t v = 0; v < vertices.size(); ++v) {
      const uint64_t hash = hash_of(vertices[v]);
      add(hash * bucket_count >> 32, hash << 32 | v);
    }
  });
  std::vector<uint32_t> first(vertices.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (size_t b = 0; b < bucket_count; ++b)
    find_first_in_bucket(vertices, {&buckets.item[0] + buckets.start[b], buckets[b].size()}, first);
  return first;
}

/// Calls visit(from, to) for the edges of all triangles with three places.
template <typename Visit>
static void for_each_edge(std::span<const Triangle> triangles, const std::vector<uint32_t>& place,
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
                                 const std::vector<uint32_t>& place) {
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
  census.place = first_at_place(vertices);
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
