#pragma once

#include <imgui.h>

namespace burnish {

enum class SliderChange {
  kStill,
  kMoving,  ///< the value changed and may change again
  kDone,    ///< the value is what the user wants
};

/// Sliders with a field for the value to the right, as wide as there is room. Draws the slider of
/// β: the left half smooths, the right half sharpens, up to 10.
SliderChange beta_slider(const char* id, double& beta, const ImVec4& colour);

/// Draws a slider that is even in the logarithm.
SliderChange log_slider(const char* id, double& value, double low, double high, const char* format);

SliderChange linear_slider(const char* id, double& value, double low, double high,
                           const char* format);

}  // namespace burnish
