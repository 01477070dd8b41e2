#include "server/prepare/pages/plane_sides.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "common/base/limits.h"

namespace burnish {

namespace {

constexpr double kSnapDistance = 1e-7;  // cells, as snap_to_planes() of common/grid/grid.h
constexpr int kCellsPerSide = 1 << kDepthMax;
constexpr int kDepths = kDepthMax - kDepthMin;

// Bits of a vertex by axis: on a plane; a neighbour is above it; a neighbour is below it.
constexpr int kOnPlane = 0, kAbove = 3, kBelow = 6;

// Returns how far a coordinate is above the nearest plane of the deepest grid, in its cells. Zero:
// on the plane, as the coarsest grid that has this plane sees it.
double above_plane(double coordinate) {
  const double plane = std::round(coordinate);
  int zeros = 0;
  for (auto index = static_cast<int64_t>(plane); zeros < kDepths && index % 2 == 0; index /= 2)
    ++zeros;
  const double distance = coordinate - plane;
  return std::abs(distance) < kSnapDistance * (1 << zeros) ? 0 : distance;
}

uint16_t planes_of(const Vec3d& place) {
  uint16_t bits = 0;
  for (int axis = 0; axis < 3; ++axis)
    if (above_plane(place[axis]) == 0) bits |= 1 << (kOnPlane + axis);
  return bits;
}

// Returns on which sides of the planes of `place` another corner of its triangle lies.
uint16_t sides_of(const Vec3d& place, uint16_t planes, const Vec3d& other) {
  uint16_t bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(planes >> axis & 1)) continue;
    const double plane = std::round(place[axis]);
    if (std::round(other[axis]) == plane && above_plane(other[axis]) == 0) continue;
    bits |= 1 << ((other[axis] > plane ? kAbove : kBelow) + axis);
  }
  return bits;
}

/// Gives vertices of one place the sides of all their triangles: each side of a seam has a vertex
/// of its own there, and both must come to the same step.
void join_sides(std::span<const Vec3d> vertices, std::span<uint16_t> bits,
                const ScratchSpace& space, const LoopPart& part) {
  ScratchArray<uint32_t> on_planes(space, vertices.size());
  size_t count = 0;
  for_each_heard(part, bits.size(), [&](size_t v) {
    if ((bits[v] & 7) != 0 && vertices[v].allFinite())
      on_planes[count++] = static_cast<uint32_t>(v);
  });
  const auto is_lower = [&](uint32_t v, uint32_t w) {
    const Vec3d &a = vertices[v], &b = vertices[w];
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  sort_heard(part, on_planes.begin(), on_planes.begin() + count, is_lower);
  size_t begin = 0;
  uint16_t joined = 0;
  for_each_heard(part, count, [&](size_t i) {
    joined |= bits[on_planes[i]];
    if (i + 1 < count && !is_lower(on_planes[i], on_planes[i + 1])) return;
    for (; begin <= i; ++begin) bits[on_planes[begin]] = joined;
    joined = 0;
  });
}

}  // namespace

ScratchArray<PlaneSides> find_plane_sides(const PagesInput& scan, const PageGrid& grid,
                                          const ScratchSpace& space, const LoopPart& part) {
  // A vertex without triangles may lie anywhere outside.
  const auto place = [&](uint32_t v) -> Vec3d {
    const Vec3d inside = (scan.vertices[v] - grid.origin) / grid.side;
    return inside.cwiseMax(0.0).cwiseMin(1.0) * kCellsPerSide;
  };
  ScratchArray<uint16_t> bits(space, scan.vertices.size());
  parallel_for_heard(part, bits.size(),
                     [&](size_t v) { bits[v] = planes_of(place(static_cast<uint32_t>(v))); });
  parallel_for_heard(part, scan.triangles.size(), [&](size_t t) {
    for (const uint32_t v : scan.triangles[t]) {
      const uint16_t planes = std::atomic_ref(bits[v]).load(std::memory_order_relaxed) & 7;
      if (planes == 0) continue;
      for (const uint32_t other : scan.triangles[t])
        std::atomic_ref(bits[v]).fetch_or(sides_of(place(v), planes, place(other)),
                                          std::memory_order_relaxed);
    }
  });
  join_sides(scan.vertices, {bits.data(), bits.size()}, space, part);
  ScratchArray<PlaneSides> sides(space, bits.size());
  for_each_heard(part, bits.size(), [&](size_t v) {
    const uint16_t below = bits[v] >> kBelow & ~(bits[v] >> kAbove) & 7;
    sides[v] = {static_cast<uint8_t>(bits[v] & 7), static_cast<uint8_t>(below)};
  });
  return sides;
}

}  // namespace burnish
