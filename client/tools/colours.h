#pragma once

#include <cstdint>

#include "common/base/types.h"

namespace burnish {

/// Where β lies between blue (-1: smooth all away) over 0 (keep) to red (1: sharpen); the paper's
/// colours of the brush.
float signed_part_of_beta(double beta);

/// Where a curvature (user units) lies between -1 and 1 on the histogram's axis, whose ends are
/// ±range.
float signed_part_of_kappa(double kappa, double range);

/// sRGB: blue at -1, grey at 0, red at 1.
Vec3f blue_to_red(float signed_part);

/// 0xRRGGBB as sRGB within 0..1.
Vec3f colour_of_hex(uint32_t hex);

}  // namespace burnish
