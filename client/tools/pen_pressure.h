#pragma once

#include <optional>
#include <span>

namespace burnish {

/// The pressure of a pen, as its tablet counts it.
struct PressureAxis {
  double min = 0;
  double max = 1;
  double value = 0;
};

/// Returns the value between both ends as 0 to 1. An axis without a length has 0.
double pressure_of(const PressureAxis& axis);

/// Returns the strength of dabs under a pressure of 0 to 1: that part of the brush's own, and
/// enough for a valid stroke at least.
double strength_under(double strength, double pressure);

/// Returns whether dabs under both pressures look different. A stroke has one strength, so a
/// gesture goes on as another stroke then.
bool needs_another_stroke(double begun, double now);

/// Follows the pressure of one gesture. A mouse has none: the tip of a pen that draws touches its
/// tablet when the button goes down.
class PenGesture {
 public:
  /// Returns the strongest pressure of all pens, 0 to 1; nothing: no pen touches its tablet.
  std::optional<double> begin(std::span<const PressureAxis> pens);
  /// Returns the same during the gesture; 0 after a pen has left its tablet.
  std::optional<double> go_on(std::span<const PressureAxis> pens) const;
  void end() { is_by_pen_ = false; }
  bool is_by_pen() const { return is_by_pen_; }

 private:
  bool is_by_pen_ = false;
};

}  // namespace burnish
