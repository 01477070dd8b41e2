#pragma once

#include <cstdint>

#include "common/base/types.h"

namespace burnish {

/// Returns the sRGB byte of a linear channel, by IEC 61966-2-1. Below 0 and NaN are 0, above 1
/// is 1.
uint8_t srgb_byte(float linear);

/// Returns the linear channel of an sRGB byte, 0 to 1. srgb_byte() gives the byte back.
float linear_of_srgb(uint8_t byte);

/// Returns red, green and blue, 0 to 1.
inline Vec3f linear_colour(Rgba8 colour) {
  return {linear_of_srgb(colour[0]), linear_of_srgb(colour[1]), linear_of_srgb(colour[2])};
}

/// Returns a colour with its red, green and blue changed by so much linear light, cut off at black
/// and white. No change gives the colour itself.
Rgba8 changed_colour(Rgba8 colour, const Vec3f& change);

/// Returns 0 to 1 as a byte. Below 0 and NaN are 0, above 1 is 1.
uint8_t unit_byte(float value);

}  // namespace burnish
