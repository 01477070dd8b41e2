#include "client/raster/near_clip.h"

#include <algorithm>
#include <cmath>

#include "client/raster/triangle_filler.h"

namespace burnish {
namespace {

constexpr int kPlanes = 5;
constexpr int kCornersMax = 3 + kPlanes;

/// A corner before the division by w: pixels times w.
struct ClipCorner {
  double x = 0, y = 0, nearness = 0, w = 0, inside = 0;
  ScreenVertex seen;  // as its neighbours have it
};

struct Polygon {
  std::array<ClipCorner, kCornersMax> corners;
  int count = 0;
  void add(const ClipCorner& corner) { corners[count++] = corner; }
};

double dot(const PageProjection::Row& row, const Vec3f& at) {
  return row.head<3>().cast<double>().dot(at.cast<double>()) + double(row.w());
}

// The near plane, then the four sides of the guard, a little within it.
double distance_inside(const ClipCorner& corner, int plane) {
  const double guard = 0.999 * kGuardSubpixels / kSubpixels;
  switch (plane) {
    case 0:
      return corner.inside;
    case 1:
      return guard * corner.w - corner.x;
    case 2:
      return guard * corner.w + corner.x;
    case 3:
      return guard * corner.w - corner.y;
    default:
      return guard * corner.w + corner.y;
  }
}

ScreenVertex divided(const ClipCorner& corner) {
  const auto subpixels = [&](double at) {
    const double guard = kGuardSubpixels;
    return static_cast<int32_t>(std::clamp(at / corner.w * kSubpixels, -guard, guard));
  };
  const double nearness = std::clamp(corner.nearness / corner.w, -1e30, 1.0);
  return {subpixels(corner.x), subpixels(corner.y), static_cast<float>(nearness), 0};
}

// From the inner to the outer corner, so that triangles of both sides of an edge find one point.
ClipCorner crossing(const ClipCorner& in, const ClipCorner& out, int plane) {
  const double from = distance_inside(in, plane), to = distance_inside(out, plane);
  const double part = from / (from - to);
  const auto between = [part](double a, double b) { return a + part * (b - a); };
  ClipCorner made{
      between(in.x, out.x), between(in.y, out.y),           between(in.nearness, out.nearness),
      between(in.w, out.w), between(in.inside, out.inside), {}};
  made.seen.is_beyond = 1;
  return made;
}

Polygon clipped(const Polygon& polygon, int plane) {
  Polygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const ClipCorner& here = polygon.corners[i];
    const ClipCorner& next = polygon.corners[(i + 1) % polygon.count];
    const bool is_in = distance_inside(here, plane) >= 0;
    const bool is_next_in = distance_inside(next, plane) >= 0;
    if (is_in) kept.add(here);
    if (is_in && !is_next_in) kept.add(crossing(here, next, plane));
    if (!is_in && is_next_in) kept.add(crossing(next, here, plane));
  }
  return kept;
}

}  // namespace

void fill_clipped(Visibility& visibility, const PageProjection& projection,
                  const ColumnRange& columns, bool is_shared, const std::array<Vec3f, 3>& corners,
                  const std::array<ScreenVertex, 3>& projected, uint32_t id) {
  Polygon polygon;
  for (int i = 0; i < 3; ++i) {
    const Vec3f& at = corners[i];
    polygon.add({dot(projection.x, at), dot(projection.y, at), dot(projection.nearness, at),
                 dot(projection.w, at), dot(projection.inside, at), projected[i]});
  }
  for (int plane = 0; plane < kPlanes && polygon.count > 0; ++plane)
    polygon = clipped(polygon, plane);
  std::array<ScreenVertex, kCornersMax> seen;
  for (int i = 0; i < polygon.count; ++i) {
    const ClipCorner& corner = polygon.corners[i];
    seen[i] = corner.seen.is_beyond ? divided(corner) : corner.seen;
  }
  for (int i = 2; i < polygon.count; ++i)
    fill_triangle(visibility, columns, is_shared, seen[0], seen[i - 1], seen[i], id);
}

}  // namespace burnish
