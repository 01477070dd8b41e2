#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/base/status.h"

namespace burnish {

/// The transfer curve α(κ) of section 6.2: how strongly the surface keeps its place along a
/// principal direction of curvature κ. α is constant beyond the end points; between points log α is
/// linear in κ.
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

  /// Fails: invalid_argument for no points or more than kCurvePointsMax, κ that does not strictly
  /// rise, a value outside its limits, or a contrast above kCurveContrastMax. The message names the
  /// point, the value and the limit.
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
  std::vector<double> logs_;  // of their α, computed once: they cost more than the rest of alpha()
};

/// Fails: invalid_argument that names the value and the limit when alpha is outside its limits.
Status check_alpha(double alpha);
Status check_beta(double beta);

}  // namespace burnish
