#pragma once

#include <cstdint>

#include "client/scene/lighting.h"
#include "client/scene/shade_constants.h"

namespace burnish {

inline constexpr int kShadeBatch = 256;

/// Pixels, or parts of pixels, that are lit side by side.
struct ShadeBatch {
  using Numbers = float[kShadeBatch];

  int count = 0;
  alignas(64) Numbers eye_x, eye_y, eye_z;           ///< from the surface to the eye; any length
  alignas(64) Numbers normal_x, normal_y, normal_z;  ///< camera space; any length
  alignas(64) Numbers facing;                        ///< below 0: the back of the triangle is seen
  alignas(64) Numbers ridge;
  alignas(64) Numbers base_r, base_g, base_b;  ///< linear
  alignas(64) Numbers over_r, over_g, over_b;  ///< linear: what rings put on top
  alignas(64) Numbers left;                    ///< part of the surface that rings leave

  // Results: the colour in sRGB, 0 to 1; the normal to the eye, unit length; the light's strength.
  alignas(64) Numbers red, green, blue;
  alignas(64) Numbers shown_x, shown_y, shown_z;
  alignas(64) Numbers strength;
};

/// The light of a picture.
struct LightTerms {
  LightKind kind = LightKind::kClay;
  ShadeVector to_lamp{0, 0, 1};
  float specular = 0;
  float by_ridge = 1;  ///< 0: lights that find ridges in the picture leave those of vertices alone
  float turns_back = 1;  ///< 0: normals face the eye anyway
  float fading = 0;      ///< 1: grey
};

/// Lights all of a batch as the shaders of client/gl do.
void light_batch(const LightTerms& terms, ShadeBatch& batch);

}  // namespace burnish
