#include "common/mesh/surface_triangles.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/base/heard_groups.h"

namespace burnish {
namespace {

bool has_three_places(const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

Triangle sorted(Triangle t) {
  std::ranges::sort(t);
  return t;
}

/// Triangles of three places by the least of these.
struct Fans {
  ScratchArray<uint64_t> first;  ///< per place, and one past the last
  ScratchArray<uint32_t> triangle;

  size_t count() const { return first.size() - 1; }
  std::span<uint32_t> operator[](size_t place) {
    return {triangle.begin() + first[place], triangle.begin() + first[place + 1]};
  }
};

Fans collect_fans(const TrianglesAtPlaces& triangles, size_t vertices, const ScratchSpace& space,
                  const LoopPart& part) {
  Fans fans;
  fans.first = ScratchArray<uint64_t>(space, vertices + 1);
  for_each_heard(part.of(0, 0.4), triangles.size(), [&](size_t t) {
    const Triangle places = triangles[t];
    if (has_three_places(places)) ++fans.first[std::ranges::min(places)];
  });
  std::exclusive_scan(fans.first.begin(), fans.first.end(), fans.first.begin(), uint64_t{0});
  fans.triangle = ScratchArray<uint32_t>(space, fans.first.back());
  for_each_heard(part.of(0.4, 1), triangles.size(), [&](size_t t) {
    const Triangle places = triangles[t];
    if (!has_three_places(places)) return;
    fans.triangle[fans.first[std::ranges::min(places)]++] = static_cast<uint32_t>(t);
  });
  // Each entry is now at its fan's end, where the next fan starts.
  std::rotate(fans.first.begin(), fans.first.end() - 1, fans.first.end());
  fans.first[0] = 0;
  return fans;
}

/// Marks the first of all copies in a fan.
template <typename Sort>
void mark_first(const TrianglesAtPlaces& triangles, std::span<uint32_t> fan,
                ScratchArray<uint8_t>& is_surface, const Sort& sort) {
  const auto key = [&](uint32_t t) { return std::tuple(sorted(triangles[t]), t); };
  if (fan.size() > 1) sort(fan, [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  for (size_t i = 0; i < fan.size(); ++i)
    is_surface[fan[i]] = i == 0 || sorted(triangles[fan[i]]) != sorted(triangles[fan[i - 1]]);
}

}  // namespace

SurfaceTriangles::SurfaceTriangles(const TrianglesAtPlaces& triangles, size_t vertices,
                                   const ScratchSpace& space, const LoopPart& part)
    : is_surface_(space, triangles.size()) {
  Fans fans = collect_fans(triangles, vertices, space, part.of(0, 0.5));
  for_each_group_heard(
      part.of(0.5, 1), fans.count(), [&](size_t v) { return fans[v].size(); },
      [&](size_t v, const auto& sort) { mark_first(triangles, fans[v], is_surface_, sort); });
}

}  // namespace burnish
