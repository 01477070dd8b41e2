#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "common/edit/transfer_curve.h"

namespace burnish {

inline constexpr double kFidelityMin = 1;    // of the slider and the plot
inline constexpr double kFidelityMax = 500;  // at least; a fine grid has more

/// A transfer curve as points that users drag in a plot. The plot's x runs from 0 to 1 evenly in
/// asinh(κ), like the histogram's bins; y runs from 0 to 1 evenly in log α.
class CurveEditor {
 public:
  /// `kappa_range`: the plot's ends, equal to the histogram's; `alpha_max`: its upper end. Needs:
  /// kappa_range > 0, alpha_max > kFidelityMin.
  explicit CurveEditor(double kappa_range, const TransferCurve& curve = TransferCurve(50),
                       double alpha_max = kFidelityMax);

  Eigen::Vector2d place_of(const TransferCurve::Point& point) const;
  TransferCurve::Point point_at(const Eigen::Vector2d& place) const;

  const std::vector<TransferCurve::Point>& points() const { return points_; }
  double kappa_range() const { return kappa_range_; }  ///< of the plot's ends
  double alpha_max() const { return alpha_max_; }      ///< of the plot's upper end

  /// Returns the curve of the points, which is always valid.
  TransferCurve curve() const;

  /// Replaces the curve and ends a drag.
  void set_curve(const TransferCurve& curve);

  /// Returns the point nearest to a place, if it is within `reach`; reach.x and reach.y are the
  /// half axes of an ellipse in the plot.
  std::optional<size_t> point_near(const Eigen::Vector2d& place,
                                   const Eigen::Vector2d& reach) const;

  /// Adds a point and drags it. Returns false at kCurvePointsMax, or if the point would touch a
  /// neighbour.
  bool add(const Eigen::Vector2d& place);
  /// Removes a point. Returns false for the last remaining point.
  bool remove(size_t index);

  void begin_drag(size_t index) {
    dragged_ = index;
    before_drag_ = points_;
  }
  /// Moves the dragged point as far as its neighbours, the limits of α and of contrast allow.
  void drag_to(const Eigen::Vector2d& place);
  /// Ends the drag. Returns false if the curve has not changed.
  bool end_drag() {
    dragged_.reset();
    return points_ != before_drag_;
  }
  std::optional<size_t> dragged() const { return dragged_; }

  /// Returns the geometric mean of the points' α, which the fidelity slider shows.
  double fidelity() const;
  /// Multiplies all α so that fidelity() becomes `alpha`, as far as the limits allow.
  void set_fidelity(double alpha);

 private:
  double kappa_range_;
  double alpha_max_;
  double axis_end_;                           // asinh(kappa_range_)
  std::vector<TransferCurve::Point> points_;  // kappa rises
  std::optional<size_t> dragged_;
  std::vector<TransferCurve::Point> before_drag_;
};

}  // namespace burnish
