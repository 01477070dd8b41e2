#include "server/prepare/clip.h"

namespace burnish {

Polygon clip(const Polygon& polygon, int axis, double plane, double sign) {
  Polygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const Vec3d& p = polygon.vertices[i];
    const Vec3d& q = polygon.vertices[i + 1 == polygon.count ? 0 : i + 1];
    const double dp = sign * (p[axis] - plane);
    const double dq = sign * (q[axis] - plane);
    if (dp >= 0) kept.push(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
      Vec3d cut = p + (q - p) * (dp / (dp - dq));
      cut[axis] = plane;
      kept.push(cut);
    }
  }
  return kept;
}

static Polygon polygon_of(const std::array<Vec3d, 3>& corners) {
  Polygon polygon;
  std::ranges::copy(corners, polygon.vertices.begin());
  polygon.count = 3;
  return polygon;
}

struct Extent {
  double low, high;
};

static Extent extent_of(const Polygon& polygon, int axis) {
  double low = polygon.vertices[0][axis], high = low;
  for (int i = 1; i < polygon.count; ++i) {
    low = std::min(low, polygon.vertices[i][axis]);
    high = std::max(high, polygon.vertices[i][axis]);
  }
  return {low, high};
}

Polygon clip_to_slab(const Polygon& polygon, int axis, int slab) {
  const auto [low, high] = extent_of(polygon, axis);
  Polygon kept = low < slab ? clip(polygon, axis, slab, 1) : polygon;
  return high > slab + 1 ? clip(kept, axis, slab + 1, -1) : kept;
}

Polygon clip_to_cell(const std::array<Vec3d, 3>& triangle, const Vec3i& cell) {
  Polygon polygon = polygon_of(triangle);
  for (int axis = 0; axis < 3 && polygon.count > 0; ++axis)
    polygon = clip_to_slab(polygon, axis, cell[axis]);
  return polygon;
}

SlabRange slabs_of(const Polygon& polygon, int axis) {
  const auto [low, high] = extent_of(polygon, axis);
  const int first = static_cast<int>(std::floor(low));
  const int last = static_cast<int>(std::ceil(high)) - 1;
  return {first, std::max(first, last)};
}

// Returns the slabs that a polygon meets or touches.
static SlabRange slabs_touched(const Polygon& polygon, int axis) {
  const auto [low, high] = extent_of(polygon, axis);
  return {static_cast<int>(std::ceil(low)) - 1, static_cast<int>(std::floor(high))};
}

template <SlabRange (*slabs)(const Polygon&, int)>
static void add_columns(const Polygon& whole, std::vector<CellColumn>& columns) {
  const SlabRange x = slabs(whole, 0);
  for (int i = x.first; i <= x.last; ++i) {
    const Polygon in_x = x.first == x.last ? whole : clip_to_slab(whole, 0, i);
    if (in_x.count == 0) continue;
    const SlabRange y = slabs(in_x, 1);
    for (int j = y.first; j <= y.last; ++j) {
      const Polygon in_y = y.first == y.last ? in_x : clip_to_slab(in_x, 1, j);
      if (in_y.count > 0) columns.push_back({i, j, slabs(in_y, 2)});
    }
  }
}

void find_columns(const std::array<Vec3d, 3>& triangle, std::vector<CellColumn>& columns) {
  columns.clear();
  add_columns<slabs_of>(polygon_of(triangle), columns);
}

void add_columns_along(const Vec3d& a, const Vec3d& b, std::vector<CellColumn>& columns) {
  add_columns<slabs_touched>(polygon_of({a, b, b}), columns);
}

}  // namespace burnish
