#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "client/scene/colour_ends.h"
#include "client/scene/lighting.h"
#include "common/base/types.h"

namespace burnish {

/// The meaning of the surface's colour.
enum class Colouring {
  kClay,          ///< only the shape
  kCells,         ///< values of VertexMark: blue at -127, red at 127
  kDisplacement,  ///< movement along the normal: blue inwards, red outwards
  kScan,          ///< the scan's own colours; black without
};

/// A brush's outline: all points of the original surface at this distance from its centre, drawn at
/// their displaced places. It is round on the original surface and bends with edits, so that the
/// brush changes exactly what lies inside.
struct Ring {
  Vec3d centre = Vec3d::Zero();  ///< file units, on the original surface
  double radius = 0;             ///< file units
  Vec3f colour = Vec3f::Ones();  ///< sRGB

  bool operator==(const Ring&) const = default;
};

inline constexpr size_t kRingsDrawnMax = 8;

struct DrawStyle {
  bool flat = false;       ///< one normal per triangle
  bool wireframe = false;  ///< edges of triangles on top
  Colouring colouring = Colouring::kClay;
  ColourEnds displacement;     ///< cells
  bool original = false;       ///< shows the surface without displacements
  double split = 0;            ///< left part of the width that shows the original
  bool faded = false;          ///< grey: the picture may be out of date
  std::vector<Ring> rings;     ///< at most kRingsDrawnMax are drawn
  Vec3f tint = Vec3f::Ones();  ///< sRGB, where VertexMark has a tint
  Lighting lighting;

  bool operator==(const DrawStyle&) const = default;
};

/// Returns the first column that shows the edited surface under DrawStyle::split.
inline int split_column(double split, int width) {
  return static_cast<int>(std::lround(std::clamp(split, 0.0, 1.0) * width));
}

}  // namespace burnish
