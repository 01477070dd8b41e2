#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "common/sheets/chart.h"

namespace burnish {

inline constexpr double kRasterReach = 0x1p20;  // pixels; edges stay exact in 64 bits

/// Calls visit(x, y, weights) for each pixel of a picture whose centre lies in a triangle; pixel 0
/// has its centre at 1/2. Corners are rounded to 1/256 pixel, then all is exact: of triangles that
/// share a side, one alone gets a centre on it. Draws counter-clockwise triangles only, and none
/// with a corner beyond kRasterReach. The weights are those of the corners.
template <typename Visit>
void draw_triangle(const std::array<Vec2d, 3>& corners, int width, int height, Visit&& visit) {
  constexpr int64_t kOne = 256;
  std::array<std::array<int64_t, 2>, 3> at;
  std::array<int64_t, 2> least = {INT64_MAX, INT64_MAX};
  std::array<int64_t, 2> most = {INT64_MIN, INT64_MIN};
  for (int k = 0; k < 3; ++k)
    for (int axis = 0; axis < 2; ++axis) {
      if (!(std::abs(corners[k][axis]) <= kRasterReach)) return;
      at[k][axis] = std::llround(corners[k][axis] * kOne);
      least[axis] = std::min(least[axis], at[k][axis]);
      most[axis] = std::max(most[axis], at[k][axis]);
    }
  // Twice the area left of the way from corner k + 1 to corner k + 2, seen from a point.
  const auto edge = [&at](int k, int64_t x, int64_t y) {
    const auto& a = at[(k + 1) % 3];
    const auto& b = at[(k + 2) % 3];
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  };
  const int64_t area = edge(0, at[0][0], at[0][1]);
  if (area <= 0) return;
  // A centre on a side belongs to the triangle whose side points down, or left where it is level.
  std::array<int64_t, 3> end;
  for (int k = 0; k < 3; ++k) {
    const auto& a = at[(k + 1) % 3];
    const auto& b = at[(k + 2) % 3];
    end[k] = b[1] > a[1] || (b[1] == a[1] && b[0] < a[0]) ? 0 : 1;
  }
  const auto first = [](int64_t place) {
    return std::max<int64_t>(0, (place + kOne / 2 - 1) >> 8);
  };
  const auto last = [](int64_t place, int size) {
    return std::min<int64_t>(size - 1, (place - kOne / 2) >> 8);
  };
  for (int64_t y = first(least[1]); y <= last(most[1], height); ++y)
    for (int64_t x = first(least[0]); x <= last(most[0], width); ++x) {
      std::array<int64_t, 3> inside;
      for (int k = 0; k < 3; ++k) inside[k] = edge(k, kOne * x + kOne / 2, kOne * y + kOne / 2);
      if (inside[0] < end[0] || inside[1] < end[1] || inside[2] < end[2]) continue;
      visit(static_cast<int>(x), static_cast<int>(y),
            Vec3d(static_cast<double>(inside[0]), static_cast<double>(inside[1]),
                  static_cast<double>(inside[2])) /
                static_cast<double>(area));
    }
}

/// Calls visit(x, y, weights) for the pixels along the longest side of a triangle: for one that is
/// too thin to hold a centre. Draws none that turns clockwise, and none beyond kRasterReach.
template <typename Visit>
void draw_needle(const std::array<Vec2d, 3>& corners, int width, int height, Visit&& visit) {
  constexpr double kInside = 0.2;  // of the third corner
  const Vec2d a = corners[1] - corners[0], b = corners[2] - corners[0];
  if (a.x() * b.y() - a.y() * b.x() < 0) return;
  int first = 0;
  const auto side = [&](int k) { return (corners[(k + 1) % 3] - corners[k]).norm(); };
  for (int k = 0; k < 3; ++k) {
    if (!(corners[k].cwiseAbs().maxCoeff() <= kRasterReach)) return;
    if (side(k) > side(first)) first = k;
  }
  const int steps = 1 + static_cast<int>(std::min<double>(2 * side(first), 2 * (width + height)));
  for (int step = 0; step < steps; ++step) {
    const double along = (step + 0.5) / steps;
    Vec3d weights;
    weights[first] = (1 - kInside) * (1 - along);
    weights[(first + 1) % 3] = (1 - kInside) * along;
    weights[(first + 2) % 3] = kInside;
    const Vec2d at = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    if (at.minCoeff() < 0 || at.x() >= width || at.y() >= height) continue;
    visit(static_cast<int>(at.x()), static_cast<int>(at.y()), weights);
  }
}

}  // namespace burnish
