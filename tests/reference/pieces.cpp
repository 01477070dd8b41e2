#include "tests/reference/pieces.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace burnish::reference {

Vec3d snapped(const Vec3d& grid_point) {
  Vec3d point = grid_point;
  for (double& x : point)
    if (std::abs(x - std::round(x)) < 1e-7) x = std::round(x);
  return point;
}

namespace {

struct Halves {
  Polygon below, above;
};

Halves cut(const Polygon& polygon, int axis, double plane) {
  Halves halves;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d& a = polygon[i];
    const Vec3d& b = polygon[(i + 1) % polygon.size()];
    if (a[axis] <= plane) halves.below.push_back(a);
    if (a[axis] >= plane) halves.above.push_back(a);
    if ((a[axis] < plane && b[axis] > plane) || (a[axis] > plane && b[axis] < plane)) {
      Vec3d crossing = a + (plane - a[axis]) / (b[axis] - a[axis]) * (b - a);
      crossing[axis] = plane;
      halves.below.push_back(crossing);
      halves.above.push_back(crossing);
    }
  }
  return halves;
}

void cut_from_axis(int axis, const Polygon& polygon, Lattice& cell,
                   const std::function<void(const Lattice&, const Polygon&)>& sink) {
  if (axis == 3) return sink(cell, polygon);
  const auto [least, most] =
      std::minmax_element(polygon.begin(), polygon.end(),
                          [&](const Vec3d& a, const Vec3d& b) { return a[axis] < b[axis]; });
  const int first = static_cast<int>(std::floor((*least)[axis]));
  const int last = std::max(first, static_cast<int>(std::ceil((*most)[axis])) - 1);
  Polygon rest = polygon;
  for (int slab = first; slab < last; ++slab) {
    Halves halves = cut(rest, axis, slab + 1);
    cell[axis] = slab;
    cut_from_axis(axis + 1, halves.below, cell, sink);
    rest = std::move(halves.above);
  }
  cell[axis] = last;
  cut_from_axis(axis + 1, rest, cell, sink);
}

struct GaussLegendre {
  std::array<double, 5> position, weight;
};

/// The rule of five points on [0, 1], exact for degree 9.
GaussLegendre gauss_legendre() {
  const double inner = std::sqrt(5 - 2 * std::sqrt(10. / 7)) / 3;
  const double outer = std::sqrt(5 + 2 * std::sqrt(10. / 7)) / 3;
  const double inner_weight = (322 + 13 * std::sqrt(70.)) / 1800;
  const double outer_weight = (322 - 13 * std::sqrt(70.)) / 1800;
  return {{(1 - outer) / 2, (1 - inner) / 2, 0.5, (1 + inner) / 2, (1 + outer) / 2},
          {outer_weight, inner_weight, 64. / 225, inner_weight, outer_weight}};
}

}  // namespace

void cut_at_grid_planes(const Polygon& triangle,
                        const std::function<void(const Lattice&, const Polygon&)>& sink) {
  Lattice cell{};
  cut_from_axis(0, triangle, cell, sink);
}

std::vector<QuadraturePoint> quadrature(const Polygon& polygon) {
  static const GaussLegendre rule = gauss_legendre();
  std::vector<QuadraturePoint> points;
  for (size_t i = 2; i < polygon.size(); ++i) {
    const Vec3d& a = polygon[0];
    const Vec3d ab = polygon[i - 1] - a;
    const Vec3d bc = polygon[i] - polygon[i - 1];
    const double twice_area = ab.cross(bc).norm();
    for (int m = 0; m < 5; ++m) {
      for (int n = 0; n < 5; ++n) {
        // (s, t) in the unit square maps to a + s (ab + t bc), with Jacobian s * twice the area.
        const double s = rule.position[m];
        points.push_back({a + s * (ab + rule.position[n] * bc),
                          rule.weight[m] * rule.weight[n] * s * twice_area});
      }
    }
  }
  return points;
}

}  // namespace burnish::reference
