#include "server/fields/edge_census.h"

#include <algorithm>
#include <numeric>

namespace burnish {

/// Returns for each vertex the least vertex at its place.
static std::vector<uint32_t> first_at_place(std::span<const Vec3d> vertices) {
  std::vector<uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](uint32_t v) {
    return std::array{vertices[v].x(), vertices[v].y(), vertices[v].z()};
  };
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<uint32_t> first(vertices.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && vertices[order[i]] == vertices[order[i - 1]];
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Orders edges by their ends; the lowest bit is the direction. Needs: vertices below 2^31.
static uint64_t edge_key(uint32_t from, uint32_t to) {
  return uint64_t{std::min(from, to)} << 32 | uint64_t{std::max(from, to)} << 1 |
         uint64_t{from > to};
}

template <typename Visit>
static void for_each_side(const Triangle& triangle, const Visit& visit) {
  if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
    return;
  for (int side = 0; side < 3; ++side) visit(triangle[side], triangle[(side + 1) % 3]);
}

static std::vector<uint64_t> sorted_edges(std::span<const Triangle> triangles) {
  std::vector<uint64_t> keys;
  keys.reserve(3 * triangles.size());
  for (const Triangle& triangle : triangles)
    for_each_side(triangle,
                  [&](uint32_t from, uint32_t to) { keys.push_back(edge_key(from, to)); });
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Leaves the keys of edges of exactly one triangle. Returns whether the surface is closed.
static bool keep_single(std::vector<uint64_t>& keys) {
  bool is_closed = !keys.empty();
  size_t kept = 0;
  for (size_t i = 0; i < keys.size();) {
    size_t end = i, backward = 0;
    for (; end < keys.size() && keys[end] >> 1 == keys[i] >> 1; ++end) backward += keys[end] & 1;
    is_closed &= 2 * backward == end - i;
    const uint64_t key = keys[i];
    if (end - i == 1) keys[kept++] = key;
    i = end;
  }
  keys.resize(kept);
  return is_closed;
}

EdgeCensus take_edge_census(std::span<const Vec3d> vertices, std::span<const Triangle> triangles) {
  EdgeCensus census;
  census.place = first_at_place(vertices);
  const std::vector<uint32_t>& first = census.place;
  census.triangles.reserve(triangles.size());
  for (const Triangle& t : triangles)
    census.triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
  std::vector<uint64_t> single = sorted_edges(census.triangles);
  census.is_closed = keep_single(single);
  for (const Triangle& triangle : census.triangles)
    for_each_side(triangle, [&](uint32_t from, uint32_t to) {
      if (std::binary_search(single.begin(), single.end(), edge_key(from, to)))
        census.rims.push_back({from, to});
    });
  return census;
}

}  // namespace burnish
