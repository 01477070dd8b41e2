#pragma once

#include <imgui.h>

namespace burnish {

enum class SliderChange {
  kStill,
  kMoving,  ///< the value changed and may change again
  kDone,    ///< the value is what the user wants
};

/// A slider with a field for its value behind it, as wide as there is room.
/// The slider of β: the left half smooths, the right half sharpens, up to ten.
SliderChange beta_slider(const char* id, double& beta, const ImVec4& colour);

/// Even in the logarithm.
SliderChange log_slider(const char* id, double& value, double low, double high, const char* format);

SliderChange linear_slider(const char* id, double& value, double low, double high,
                           const char* format);

}  // namespace burnish
