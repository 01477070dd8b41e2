#pragma once

#include <cstdint>

#include "client/scene/shade_constants.h"

namespace burnish {

// Replaces functions of shaders in loops over pixels side by side: no branches and no calls.

#define BURNISH_SHADE [[gnu::always_inline]] inline

BURNISH_SHADE float lesser(float a, float b) {
  return a < b ? a : b;
}
BURNISH_SHADE float greater(float a, float b) {
  return a > b ? a : b;
}
BURNISH_SHADE float clamped(float a) {
  return lesser(greater(a, 0.0f), 1.0f);
}
BURNISH_SHADE float mixed(float a, float b, float part) {
  return a + part * (b - a);
}
BURNISH_SHADE float smooth_step(float low, float high, float at) {
  const float part = clamped((at - low) / (high - low));
  return part * part * (3 - 2 * part);
}

BURNISH_SHADE ShadeVector operator+(ShadeVector a, ShadeVector b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
BURNISH_SHADE ShadeVector operator-(ShadeVector a, ShadeVector b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
BURNISH_SHADE ShadeVector operator*(float a, ShadeVector b) {
  return {a * b.x, a * b.y, a * b.z};
}
BURNISH_SHADE ShadeVector by_parts(ShadeVector a, ShadeVector b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
BURNISH_SHADE float dot(ShadeVector a, ShadeVector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
BURNISH_SHADE ShadeVector cross(ShadeVector a, ShadeVector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
BURNISH_SHADE float length_of(ShadeVector a) {
  return __builtin_sqrtf(dot(a, a));
}
BURNISH_SHADE ShadeVector unit(ShadeVector a) {
  return (1 / greater(length_of(a), 1e-30f)) * a;
}
BURNISH_SHADE ShadeVector mixed(ShadeVector a, ShadeVector b, float part) {
  return a + part * (b - a);
}
BURNISH_SHADE float luminance(ShadeVector colour) {
  return dot(colour, {0.21f, 0.72f, 0.07f});
}

/// Returns the logarithm to base 2, within 3e-7 of its size. Needs: not negative; 0 gives -127.
BURNISH_SHADE float fast_log2(float a) {
  const auto bits = __builtin_bit_cast(int32_t, a);
  const int32_t exponent = (bits - 0x3f3504f3) >> 23;  // the rest lies around 1
  const float rest = __builtin_bit_cast(float, bits - exponent * (1 << 23));
  const float t = (rest - 1) / (rest + 1), square = t * t;
  const float series = ((square / 7 + 0.2f) * square + 1.0f / 3) * square + 1;
  return static_cast<float>(exponent) + 2.88539008f * t * series;
}

/// Returns 2 to the power, within 2e-7 of it, for powers within -126 to 126; else as at the ends.
BURNISH_SHADE float fast_exp2(float power) {
  const float within = lesser(greater(power, -126.0f), 126.0f);
  const float whole = (within + 12582912.0f) - 12582912.0f;  // rounds
  const float x = 0.693147181f * (within - whole);
  const float series =
      (((((x / 720 + 1.0f / 120) * x + 1.0f / 24) * x + 1.0f / 6) * x + 0.5f) * x + 1) * x + 1;
  return series * __builtin_bit_cast(float, (static_cast<int32_t>(whole) + 127) * (1 << 23));
}

/// Needs: `base` is not negative.
BURNISH_SHADE float power(float base, float exponent) {
  return fast_exp2(exponent * fast_log2(base));
}

BURNISH_SHADE ShadeVector linear(ShadeVector srgb) {
  return {power(srgb.x, shade::kGamma), power(srgb.y, shade::kGamma), power(srgb.z, shade::kGamma)};
}

}  // namespace burnish
