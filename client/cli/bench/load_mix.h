#pragma once

#include <array>
#include <random>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// The work of a user for about a second.
enum class Activity {
  kDraw,   ///< looks
  kDrag,   ///< drags the slider
  kPaint,  ///< paints a stroke
};

/// How often each activity is chosen.
struct LoadMix {
  std::array<double, 3> weight = {1, 1, 2};  ///< in the order of Activity; not all 0

  Activity choose(std::mt19937& random) const;
};

/// Parses "draw=1,drag=1,paint=2"; an activity that is not named has weight 0.
/// Fails: invalid_argument that names the wrong part.
Result<LoadMix> parse_load_mix(const std::string& text);

}  // namespace burnish
