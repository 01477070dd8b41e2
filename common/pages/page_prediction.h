#pragma once

#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/pages/octahedral.h"
#include "common/pages/page.h"
#include "common/pages/page_walk.h"

namespace burnish {

/// Predicts a position from earlier ones, modulo 2^32.
inline std::array<uint32_t, 3> predicted_position(const WalkOrigin& origin,
                                                  std::span<const Vec3i> positions) {
  std::array<uint32_t, 3> predicted;
  for (int axis = 0; axis < 3; ++axis)
    predicted[axis] = static_cast<uint32_t>(positions[origin.a][axis]) +
                      static_cast<uint32_t>(positions[origin.b][axis]) -
                      static_cast<uint32_t>(positions[origin.c][axis]);
  return predicted;
}

/// Returns the mean of the colours at a and b, rounded down.
inline Rgba8 predicted_colour(const WalkOrigin& origin, std::span<const Rgba8> colours) {
  Rgba8 predicted;
  for (int channel = 0; channel < 4; ++channel)
    predicted[channel] =
        static_cast<uint8_t>((colours[origin.a][channel] + colours[origin.b][channel]) / 2);
  return predicted;
}

/// Sums (p1 - p0) × (p2 - p0) of each vertex's triangles. Shapes: one sum per position.
inline std::vector<NormalSum> sum_normals(std::span<const PageTriangle> triangles,
                                          std::span<const Vec3i> positions) {
  std::vector<NormalSum> sums(positions.size(), NormalSum{});
  for (const PageTriangle& triangle : triangles) {
    const Eigen::Matrix<int64_t, 3, 1> p0 = positions[triangle[0]].cast<int64_t>();
    const auto normal = (positions[triangle[1]].cast<int64_t>() - p0)
                            .cross(positions[triangle[2]].cast<int64_t>() - p0)
                            .eval();
    for (const uint16_t vertex : triangle)
      for (int axis = 0; axis < 3; ++axis) sums[vertex][axis] += normal[axis];
  }
  return sums;
}

}  // namespace burnish
