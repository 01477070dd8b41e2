#pragma once

#include <cmath>
#include <string>

#include "common/base/limits.h"
#include "common/base/line_text.h"
#include "common/base/status.h"
#include "common/pages/directory.h"

namespace burnish {

/// Fails: data_loss that names the value, unless `least` <= value <= `most`.
template <typename T>
Status check_page_value(const std::string& name, T value, T least, T most) {
  if (value >= least && value <= most) return Status::ok();  // false for NaN
  LineText message;
  message << name << " " << value << " is outside " << least << ".." << most;
  return data_loss(message.text());
}

/// Checks that bounds from outside are finite and not negative.
inline Status check_bounds(const std::string& name, const PageBounds& bounds) {
  constexpr auto kReach = static_cast<float>(16 * kCoordinateMagnitudeMax);
  for (const float coordinate : bounds.centre)
    RETURN_IF_ERROR(check_page_value(name + ": centre", coordinate, -kReach, kReach));
  RETURN_IF_ERROR(check_page_value(name + ": radius", bounds.radius, 0.0f, kReach));
  RETURN_IF_ERROR(check_page_value(name + ": error", bounds.error, 0.0f, kReach));
  return check_page_value(name + ": edge", bounds.edge, 0.0f, kReach);
}

}  // namespace burnish
