#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "common/edit/transfer_curve.h"

namespace burnish {

/// A transfer curve as points that are dragged in a plot. The plot's x runs from 0 to 1 evenly in
/// asinh(κ), as the histogram's bins do; y from 0 to 1 evenly in log α.
class CurveEditor {
 public:
  /// `kappa_range`: the plot's ends, as the histogram's. Needs: positive.
  explicit CurveEditor(double kappa_range, const TransferCurve& curve = TransferCurve(50));

  Eigen::Vector2d place_of(const TransferCurve::Point& point) const;
  TransferCurve::Point point_at(const Eigen::Vector2d& place) const;

  const std::vector<TransferCurve::Point>& points() const { return points_; }
  double kappa_range() const { return kappa_range_; }  ///< of the plot's ends

  /// The curve that the points make: always a valid one.
  TransferCurve curve() const;

  /// Ends a drag.
  void set_curve(const TransferCurve& curve);

  /// The point nearest to a place, if it is within `reach` of the plot; reach.x and reach.y are the
  /// half axes of an ellipse.
  std::optional<size_t> point_near(const Eigen::Vector2d& place,
                                   const Eigen::Vector2d& reach) const;

  /// Adds a point and drags it. False at kCurvePointsMax, or where it would touch a neighbour.
  bool add(const Eigen::Vector2d& place);
  /// False for the last point that is left.
  bool remove(size_t index);

  void begin_drag(size_t index) {
    dragged_ = index;
    before_drag_ = points_;
  }
  /// Moves the dragged point as far as its neighbours, the limits of α and of contrast allow.
  void drag_to(const Eigen::Vector2d& place);
  /// False when the curve is what it was before.
  bool end_drag() {
    dragged_.reset();
    return points_ != before_drag_;
  }
  std::optional<size_t> dragged() const { return dragged_; }

  /// The geometric mean of the points' α: what the fidelity slider shows.
  double fidelity() const;
  /// Multiplies all α so that fidelity() is this, as far as the limits allow.
  void set_fidelity(double alpha);

 private:
  double kappa_range_;
  double axis_end_;                           // asinh of it
  std::vector<TransferCurve::Point> points_;  // kappa rises
  std::optional<size_t> dragged_;
  std::vector<TransferCurve::Point> before_drag_;
};

inline constexpr double kFidelityMin = 1;  // of the slider and the plot
inline constexpr double kFidelityMax = 500;

/// What α keeps: surface waves shorter than 2π times this, in file units, are changed.
inline double detail_size(double length_unit, double alpha) {
  return length_unit / alpha;
}

}  // namespace burnish
