#pragma once

#include <array>
#include <random>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// What a person at a client does for a second or so.
enum class Activity {
  kDraw,   ///< looks
  kDrag,   ///< drags the slider
  kPaint,  ///< paints a stroke
};

/// How often each of them is chosen.
struct LoadMix {
  std::array<double, 3> weight = {1, 1, 2};  ///< in the order of Activity; not all 0

  Activity choose(std::mt19937& random) const;
};

/// "draw=1,drag=1,paint=2"; what is not named has weight 0.
/// Fails: invalid_argument naming what is wrong.
Result<LoadMix> parse_load_mix(const std::string& text);

}  // namespace burnish
