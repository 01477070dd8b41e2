#pragma once

#include <cmath>
#include <cstdint>

#include "client/scene/page_renderer.h"

namespace burnish {

// A vertex of a page on the graphics card: 52 bytes in five streams, since they change at
// different times. Both the displaced and the original surface are drawn from them.

/// A unit normal in two integers of 12 bits, x lowest, and a ridge (vertex_ridges()) times 127 in
/// the highest 8 bits. The normal is stretched onto the octahedron |x| + |y| + |z| = 1, whose lower
/// half is folded outwards into the square -1 <= x, y <= 1. Its error is below 0.05 degrees.
using PackedShade = int32_t;

inline PackedShade packed_shade(const Vec3f& normal, float ridge) {
  constexpr float kSquareSteps = 2047, kRidgeSteps = 127;
  Eigen::Vector2f square = normal.head<2>() / normal.lpNorm<1>();
  if (normal.z() < 0) {
    const Eigen::Vector2f folded = Eigen::Vector2f::Ones() - square.cwiseAbs().reverse();
    for (int axis = 0; axis < 2; ++axis) square[axis] = std::copysign(folded[axis], square[axis]);
  }
  const auto bits = [](float part, float steps) {
    return static_cast<uint32_t>(std::lround(part * steps));
  };
  const uint32_t x = bits(square.x(), kSquareSteps), y = bits(square.y(), kSquareSteps);
  return static_cast<PackedShade>((x & 0xfff) | (y & 0xfff) << 12 | bits(ridge, kRidgeSteps) << 24);
}

/// Comes with the page.
struct StillVertex {
  Vec3f position;
  PackedShade shade;
  Rgba8 colour;
};
static_assert(sizeof(StillVertex) == 20);

/// Comes with each frame that moves the page.
struct MovingVertex {
  Vec3f displacement;  // cells
  PackedShade shade;
};
static_assert(sizeof(MovingVertex) == 16);

/// A TexelChange: the light, and the gain.
using TexelVertex = Eigen::Matrix<Eigen::half, 4, 1>;
static_assert(sizeof(TexelVertex) == 8);

/// Comes with values and tints.
using MarkedVertex = VertexMark;
static_assert(sizeof(MarkedVertex) == 4);

}  // namespace burnish
