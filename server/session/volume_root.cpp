#include "server/session/volume_root.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace burnish {
namespace {

/// Finds where a cubic may turn: its ends are rising. Returns how many of `turns` are within 0 to
/// limit.
int find_turns(const Cubic& c, double limit, std::array<double, 3>& turns) {
  int count = 0;
  const auto add = [&](double t) {
    if (t > 0 && t < limit) turns[count++] = t;
  };
  const double a = 3 * c[3], half_b = c[2], slope = c[1];
  const double root = half_b * half_b - a * slope;
  if (root >= 0) {
    // Without a difference of nearly equal numbers; a quotient by 0 is not within the limit.
    const double q = -(half_b + std::copysign(std::sqrt(root), half_b));
    add(q / a);
    add(slope / q);
  }
  std::sort(turns.begin(), turns.begin() + count);
  return count;
}

/// Needs: the value is below 0 at `low` and not at `high`, and rises between them.
double bisect(const Cubic& c, double low, double high) {
  for (;;) {
    const double middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) return high;
    (value_at(c, middle) < 0 ? low : high) = middle;
  }
}

/// first_zero() for a value that is below 0 at 0.
double first_zero_above(const Cubic& c, double limit) {
  std::array<double, 3> ends;
  const int turns = find_turns(c, limit, ends);
  ends[turns] = limit;
  double from = 0, best = 0;
  for (const double end : std::span(ends).first(turns + 1)) {
    if (value_at(c, end) >= 0) return bisect(c, from, end);
    if (value_at(c, end) > value_at(c, best)) best = end;
    from = end;
  }
  return best;
}

/// Follows a curve that is below 0 at 0 to its zero.
class ZeroAbove {
 public:
  ZeroAbove(const Curve& curve, const ZeroSearch& search, double at_zero)
      : curve_(curve),
        search_(search),
        low_{0, at_zero},
        best_(low_),
        steps_left_(search.steps_max) {}

  double find() {
    constexpr double kFirstShare = 1e-6, kGrowth = 4;
    double next = std::max(search_.guess, kFirstShare * search_.limit);
    for (next = std::min(next, search_.limit); !step_to(next); next *= kGrowth)
      if (next >= search_.limit || steps_left_ <= 0) return best_.place;
    while (!is_zero(best_.value) && steps_left_ > 0) step_between();
    return best_.place;
  }

 private:
  struct Point {
    double place, value;
  };

  bool is_zero(double value) const { return std::abs(value) <= search_.tolerance; }

  /// Returns whether the value is not below 0 there.
  bool step_to(double place) {
    const Point point = {std::min(place, search_.limit), curve_(std::min(place, search_.limit))};
    --steps_left_;
    const bool is_much_nearer = std::abs(point.value) < std::abs(best_.value) - search_.tolerance;
    if (is_much_nearer || (is_zero(point.value) && !is_zero(best_.value))) best_ = point;
    if (point.value < 0) low_ = point;
    if (point.value >= 0) high_ = point;
    return point.value >= 0;
  }

  /// Takes the chord, and the middle where the chord has moved one end alone: a step of the curve
  /// does not hold it up.
  void step_between() {
    const double width = high_.place - low_.place;
    const double share = -low_.value / (high_.value - low_.value);
    const bool takes_middle = width > width_ / 2;
    width_ = width;
    step_to(low_.place + width * (takes_middle ? 0.5 : share));
  }

  const Curve& curve_;
  const ZeroSearch& search_;
  Point low_, high_ = {}, best_;
  double width_ = std::numeric_limits<double>::infinity();  // before the last step
  int steps_left_;
};

}  // namespace

double curve_zero(const Curve& curve, const ZeroSearch& search) {
  const double at_zero = curve(0);
  if (std::abs(at_zero) <= search.tolerance || !(search.limit > 0)) return 0;
  if (at_zero < 0) return ZeroAbove(curve, search, at_zero).find();
  ZeroSearch mirrored = search;
  mirrored.guess = -search.guess;
  return -ZeroAbove([&](double t) { return -curve(-t); }, mirrored, -at_zero).find();
}

double first_zero(const Cubic& c, double limit) {
  if (c[0] == 0 || !(limit > 0)) return 0;
  if (c[0] < 0) return first_zero_above(c, limit);
  return -first_zero_above({-c[0], c[1], -c[2], c[3]}, limit);
}

}  // namespace burnish
