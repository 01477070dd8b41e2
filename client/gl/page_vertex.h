#pragma once

#include <cmath>
#include <cstdint>

#include "client/scene/page_renderer.h"

namespace burnish {

// A vertex of a page on the graphics card: 40 bytes in three streams, since they change at
// different times. Both the displaced and the original surface are drawn from them.

/// A unit vector times 511 in three integers of ten bits, x lowest, for GL_INT_2_10_10_10_REV.
/// Its error is below 0.1 degrees.
using PackedNormal = uint32_t;

inline PackedNormal packed_normal(const Vec3f& normal) {
  const auto bits = [](float part) {
    return static_cast<uint32_t>(std::lround(part * 511)) & 0x3ff;
  };
  return bits(normal.x()) | bits(normal.y()) << 10 | bits(normal.z()) << 20;
}

/// Comes with the page.
struct StillVertex {
  Vec3f position;
  PackedNormal normal;
  Rgba8 colour;
};
static_assert(sizeof(StillVertex) == 20);

/// Comes with each frame that moves the page.
struct MovingVertex {
  Vec3f displacement;  // cells
  PackedNormal normal;
};
static_assert(sizeof(MovingVertex) == 16);

/// Comes with values and tints. Four bytes, since graphics cards read from multiples of four.
struct MarkedVertex {
  VertexMark mark;
  uint16_t unused = 0;
};
static_assert(sizeof(MarkedVertex) == 4);

}  // namespace burnish
