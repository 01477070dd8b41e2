#pragma once

#include <array>
#include <functional>

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

/// A function that is costly to evaluate.
using Curve = std::function<double(double)>;

/// How a zero of a curve is sought.
struct ZeroSearch {
  double guess = 0;      ///< where it is expected, on either side of 0
  double limit = 0;      ///< the largest distance from 0
  double tolerance = 0;  ///< values up to this count as 0
  int steps_max = 40;    ///< evaluations
};

/// Returns a zero of a curve that begins below 0 and rises to the right, or begins above 0 and
/// falls to the left. If there is none within the limit, returns the place where the value was
/// nearest to 0, and of places that are as good the nearest to 0.
double curve_zero(const Curve& curve, const ZeroSearch& search);

}  // namespace burnish
