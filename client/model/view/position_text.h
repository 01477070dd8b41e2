#pragma once

#include <string>

#include "common/base/types.h"

namespace burnish {

/// Returns a point for other programs: "12.345 -3.1 0.02". It has the decimals that matter on a
/// scan of this diagonal.
std::string position_text(const Vec3d& point, double diagonal);

}  // namespace burnish
