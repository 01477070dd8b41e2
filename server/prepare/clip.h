#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "common/base/types.h"

namespace burnish {

/// A convex polygon with few vertices: a triangle cut by the six planes of a cell has at most nine.
struct Polygon {
  static constexpr int kVerticesMax = 12;
  std::array<Vec3d, kVerticesMax> vertices;
  int count = 0;

  void push(const Vec3d& p) { vertices[count++] = p; }
};

/// The part of `polygon` on the side sign·(x[axis] − plane) >= 0. Vertices on the plane stay.
Polygon clip(const Polygon& polygon, int axis, double plane, double sign);

/// The part of `polygon` in slab <= x[axis] <= slab + 1.
Polygon clip_to_slab(const Polygon& polygon, int axis, int slab);

/// The part of a triangle in one cell. Units: grid.
Polygon clip_to_cell(const std::array<Vec3d, 3>& triangle, const Vec3i& cell);

/// The slabs [first, last] that a polygon meets along an axis with more than a touch. A polygon
/// that lies in a grid plane belongs to the slab above.
struct SlabRange {
  int first;
  int last;
};
SlabRange slabs_of(const Polygon& polygon, int axis);

/// Calls visit(cell) once for each cell that the triangle meets. Units: grid, snapped to planes.
/// Cost: proportional to the number of cells met, also for triangles much larger than a cell.
template <typename Visit>
void for_each_cell_of_triangle(const std::array<Vec3d, 3>& triangle, Visit&& visit) {
  Polygon whole;
  for (const Vec3d& p : triangle) whole.push(p);
  const SlabRange x = slabs_of(whole, 0);
  for (int i = x.first; i <= x.last; ++i) {
    const Polygon in_x = x.first == x.last ? whole : clip_to_slab(whole, 0, i);
    if (in_x.count == 0) continue;
    const SlabRange y = slabs_of(in_x, 1);
    for (int j = y.first; j <= y.last; ++j) {
      const Polygon in_y = y.first == y.last ? in_x : clip_to_slab(in_x, 1, j);
      if (in_y.count == 0) continue;
      const SlabRange z = slabs_of(in_y, 2);
      for (int k = z.first; k <= z.last; ++k) visit(Vec3i(i, j, k));
    }
  }
}

}  // namespace burnish
