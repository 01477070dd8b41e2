#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// The transfer curve α(κ) of section 6.2: how strongly the surface holds to its place along a
/// principal direction of curvature κ. Constant beyond the ends; log α is linear in κ between.
/// Units: κ and α are dimensionless user units (κ·L, α·L with L = sqrt(area)).
class TransferCurve {
 public:
  struct Point {
    double kappa;
    double alpha;
    bool operator==(const Point&) const = default;
  };

  /// A constant α. Needs: kAlphaMin <= alpha <= kAlphaMax.
  explicit TransferCurve(double alpha);

  /// Fails: invalid_argument for no or more than kCurvePointsMax points, κ not strictly rising, a
  /// value outside its limits, or a contrast above kCurveContrastMax; names point, value, limit.
  static Result<TransferCurve> create(std::vector<Point> points);

  /// Parses "k:a,k:a,..."; k may be negative. Points may come in any order.
  static Result<TransferCurve> parse(std::string_view text);

  double alpha(double kappa) const;
  double contrast() const;  ///< max α / min α
  bool is_constant() const { return points_.size() == 1; }
  const std::vector<Point>& points() const { return points_; }
  std::string to_string() const;  ///< parses back to the same curve
  bool operator==(const TransferCurve&) const = default;

 private:
  explicit TransferCurve(std::vector<Point> points);
  std::vector<Point> points_;  // sorted by kappa, at least one
  std::vector<double> logs_;   // of their α: taken once, they else cost more than all of alpha()
};

/// alpha within its limits, or invalid_argument naming the value and the limit.
Status check_alpha(double alpha);
Status check_beta(double beta);

}  // namespace burnish
