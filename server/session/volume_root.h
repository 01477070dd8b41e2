#pragma once

#include <array>

namespace burnish {

/// c[0] + c[1] t + c[2] t² + c[3] t³.
using Cubic = std::array<double, 4>;

inline double value_at(const Cubic& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

/// Returns the zero that one comes to first from 0: upwards if c[0] < 0, downwards if c[0] > 0. It
/// follows the coefficients without a jump as long as it does not meet another zero. If there is
/// none within `limit`, returns the place on the way where the value is nearest to 0. Needs: limit
/// >= 0.
double first_zero(const Cubic& c, double limit);

}  // namespace burnish
