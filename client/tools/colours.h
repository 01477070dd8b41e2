#pragma once

#include <cstdint>

#include "common/base/types.h"

namespace burnish {

/// Maps β to the paper's colours of the brush: blue (-1: smooth everything), 0 (keep), red (1:
/// sharpen).
float signed_part_of_beta(double beta);

/// Maps a curvature (user units) to -1..1 on the histogram's axis, whose ends are ±range.
float signed_part_of_kappa(double kappa, double range);

/// Return the value at a part of -1 to 1: they undo the two functions above.
double beta_of_signed_part(double part);
double kappa_of_signed_part(double part, double range);

/// Returns sRGB: blue at -1, grey at 0, red at 1.
Vec3f blue_to_red(float signed_part);

/// Converts 0xRRGGBB to sRGB within 0..1.
Vec3f colour_of_hex(uint32_t hex);

}  // namespace burnish
