#include "server/session/volume_root.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace burnish {
namespace {

/// Where a cubic may turn: its ends are rising. Returns how many of `turns` are within 0 to limit.
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

}  // namespace

double first_zero(const Cubic& c, double limit) {
  if (c[0] == 0 || !(limit > 0)) return 0;
  if (c[0] < 0) return first_zero_above(c, limit);
  return -first_zero_above({-c[0], c[1], -c[2], c[3]}, limit);
}

}  // namespace burnish
