#include "client/tools/pen_pressure.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static constexpr double kPressureStep = 0.1;
static constexpr double kStrokeStrengthMin = 0.01;

double pressure_of(const PressureAxis& axis) {
  if (!(axis.max > axis.min)) return 0;
  return std::clamp((axis.value - axis.min) / (axis.max - axis.min), 0.0, 1.0);
}

double strength_under(double strength, double pressure) {
  return std::max(strength * pressure, kStrokeStrengthMin);
}

bool needs_another_stroke(double begun, double now) {
  return std::abs(now - begun) > kPressureStep;
}

static double strongest(std::span<const PressureAxis> pens) {
  double most = 0;
  for (const PressureAxis& pen : pens) most = std::max(most, pressure_of(pen));
  return most;
}

std::optional<double> PenGesture::begin(std::span<const PressureAxis> pens) {
  is_by_pen_ = strongest(pens) > 0;
  return go_on(pens);
}

std::optional<double> PenGesture::go_on(std::span<const PressureAxis> pens) const {
  if (!is_by_pen_) return std::nullopt;
  return strongest(pens);
}

}  // namespace burnish
