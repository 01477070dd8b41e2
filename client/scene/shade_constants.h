#pragma once

namespace burnish {

/// Linear red, green and blue; or a direction.
struct ShadeVector {
  float x, y, z;
};

// The constants of light and colour, once for the shaders of client/gl and for client/raster: each
// line is X(name, values).

#define BURNISH_SHADE_VECTORS(X)      \
  X(kSky, 0.42, 0.45, 0.50)           \
  X(kGround, 0.16, 0.14, 0.13)        \
  X(kKeyLight, 1.00, 0.95, 0.88)      \
  X(kFillLight, 0.14, 0.16, 0.20)     \
  X(kFillPlace, 0.80, 0.10, 0.45)     \
  X(kClayBase, 0.50, 0.44, 0.37)      \
  X(kCeramicBase, 0.72, 0.72, 0.70)   \
  X(kBronzeBase, 0.40, 0.22, 0.09)    \
  X(kSlopesBase, 0.55, 0.55, 0.55)    \
  X(kCeramicLamp, -0.5, 0.6, 0.6)     \
  X(kBronzeLamp, -0.4, 0.7, 0.6)      \
  X(kBronzeShine, -0.35, 0.45, 0.82)  \
  X(kBronzeGloss, 1.0, 0.85, 0.6)     \
  X(kPlain, 0.62, 0.62, 0.62)         \
  X(kBlue, 0.03, 0.16, 0.72)          \
  X(kRed, 0.72, 0.04, 0.03)           \
  X(kHeld, 0.10, 0.30, 0.52)          \
  X(kEdge, 0.05, 0.06, 0.08)          \
  X(kBackgroundLow, 0.70, 0.72, 0.75) \
  X(kBackgroundHigh, 0.93, 0.94, 0.95)

#define BURNISH_SHADE_NUMBERS(X)   \
  X(kGamma, 2.2)                   \
  X(kHatchPixels, 12.0)            \
  X(kStripePart, 0.4)              \
  X(kOverlayStrength, 0.6)         \
  X(kStripeStrength, 0.75)         \
  X(kBetweenStripesStrength, 0.25) \
  X(kTintStrength, 0.75)           \
  X(kEdgeStrength, 0.55)           \
  X(kRingInnerPixels, 0.8)         \
  X(kRingOuterPixels, 1.8)         \
  X(kGrazing, 0.02) /* cosine: the surface turns no farther from the eye */

namespace shade {

#define BURNISH_SHADE_VECTOR(name, a, b, c)                                       \
  inline constexpr ShadeVector name{static_cast<float>(a), static_cast<float>(b), \
                                    static_cast<float>(c)};
#define BURNISH_SHADE_NUMBER(name, value) inline constexpr float name = static_cast<float>(value);
BURNISH_SHADE_VECTORS(BURNISH_SHADE_VECTOR)
BURNISH_SHADE_NUMBERS(BURNISH_SHADE_NUMBER)
#undef BURNISH_SHADE_VECTOR
#undef BURNISH_SHADE_NUMBER

}  // namespace shade

}  // namespace burnish
