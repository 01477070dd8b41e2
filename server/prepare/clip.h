#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/base/types.h"

namespace burnish {

/// A convex polygon with few vertices: a triangle cut by the six planes of a cell has at most nine.
struct Polygon {
  static constexpr int kVerticesMax = 12;
  std::array<Vec3d, kVerticesMax> vertices;
  int count = 0;

  // Most polygons have three or four vertices: a copy of all twelve takes longer than the clipping.
  Polygon() = default;
  Polygon(const Polygon& other) { *this = other; }
  Polygon& operator=(const Polygon& other) {
    count = other.count;
    std::copy_n(other.vertices.begin(), count, vertices.begin());
    return *this;
  }

  void push(const Vec3d& p) { vertices[count++] = p; }
};

/// Returns the part of `polygon` on the side sign·(x[axis] − plane) >= 0. Vertices on the plane
/// stay.
Polygon clip(const Polygon& polygon, int axis, double plane, double sign);

/// Returns the part of `polygon` in slab <= x[axis] <= slab + 1.
Polygon clip_to_slab(const Polygon& polygon, int axis, int slab);

/// Returns the part of a triangle in one cell. Units: grid.
Polygon clip_to_cell(const std::array<Vec3d, 3>& triangle, const Vec3i& cell);

/// The slabs [first, last] that a polygon meets along an axis, touches left out. A polygon in a
/// grid plane belongs to the slab above.
struct SlabRange {
  int first;
  int last;
};
SlabRange slabs_of(const Polygon& polygon, int axis);

/// Cells (i, j, k) with k in a range.
struct CellColumn {
  int i, j;
  SlabRange k;
};

/// Puts the cells that the triangle meets into `columns`, in the order of i, then j, each pair
/// once. Units: grid, snapped to planes. Cost: proportional to the number of cells met, also for
/// triangles much larger than a cell.
void find_columns(const std::array<Vec3d, 3>& triangle, std::vector<CellColumn>& columns);

/// Appends the cells that the line from a to b meets or touches, in the same order.
void add_columns_along(const Vec3d& a, const Vec3d& b, std::vector<CellColumn>& columns);

}  // namespace burnish
