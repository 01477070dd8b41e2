#pragma once

#include "common/base/types.h"

namespace burnish {

/// The gamma that renderers take colours of scans for (kGamma of client/scene/shade_constants.h).
inline constexpr double kShownGamma = 2.2;

/// The effect of an edit on the texels at a vertex: a texel of light t shows gain · t + light. Both
/// are linear between the vertices of a triangle.
struct TexelChange {
  float gain = 1;
  Vec3f light = Vec3f::Zero();

  bool is_none() const { return gain == 1 && light.isZero(0); }
};

/// Returns what texels do where the colour of a vertex changes by so much linear light: a texel of
/// the vertex's colour shows the changed_colour(), and others differ from it `gain` times as much.
/// A change may go beyond black and white: the texels are cut off, not the vertex.
TexelChange texel_change(Rgba8 before, const Vec3f& change, float gain);

/// Returns what texels do where all that is known is the vertex's other colour.
TexelChange texel_change(Rgba8 before, Rgba8 after);

}  // namespace burnish
