#pragma once

#include <imgui.h>
#include <string>

#include "client/model/input/typed_number.h"
#include "client/model/tasks/message_log.h"
#include "client/panels/widgets.h"

namespace burnish {

/// A value with a slider and a field to type into.
struct ValueField {
  TypedValue limits;  ///< the name is unique in its panel
  int digits;         ///< of the number, as fixed_text() has them; 0: two decimals
  MessageLog& log;    ///< hears of text that is refused, and of limits
};

/// Sliders with a field for the value to the right, as wide as there is room. Draws the slider of
/// β: the left half smooths, the right half sharpens, up to 10.
SliderChange beta_slider(const std::string& name, double& beta, const ImVec4& colour,
                         MessageLog& log);

/// Draws a slider that is even in the logarithm.
SliderChange log_slider(const ValueField& field, double& value);

SliderChange linear_slider(const ValueField& field, double& value);

}  // namespace burnish
