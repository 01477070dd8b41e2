#include "client/tools/curve_editor.h"

#include <algorithm>
#include <cmath>

#include "common/base/check.h"
#include "common/base/limits.h"
#include "common/base/ratio.h"

namespace burnish {

static constexpr double kNeighbourGap = 0.004;  // of the plot's width

CurveEditor::CurveEditor(double kappa_range, const TransferCurve& curve, double alpha_max)
    : kappa_range_(std::min(kappa_range, 0.999 * kCurveKappaMagnitudeMax)),
      alpha_max_(alpha_max),
      axis_end_(std::asinh(kappa_range_)),
      points_(curve.points()) {}

Eigen::Vector2d CurveEditor::place_of(const TransferCurve::Point& point) const {
  const double part = std::log(point.alpha / kFidelityMin) / std::log(alpha_max_ / kFidelityMin);
  return {0.5 + 0.5 * std::asinh(point.kappa) / axis_end_, part};
}

TransferCurve::Point CurveEditor::point_at(const Eigen::Vector2d& place) const {
  return {std::sinh((2 * place.x() - 1) * axis_end_),
          between_by_ratio(kFidelityMin, alpha_max_, place.y())};
}

TransferCurve CurveEditor::curve() const {
  auto curve = TransferCurve::create(points_);
  BURNISH_CHECK(curve.is_ok(), curve.status().message());
  return std::move(curve).value();
}

void CurveEditor::set_curve(const TransferCurve& curve) {
  points_ = curve.points();
  dragged_.reset();
}

std::optional<size_t> CurveEditor::point_near(const Eigen::Vector2d& place,
                                              const Eigen::Vector2d& reach) const {
  std::optional<size_t> nearest;
  double nearest_part = 1;
  for (size_t i = 0; i < points_.size(); ++i) {
    const double part = (place_of(points_[i]) - place).cwiseQuotient(reach).norm();
    if (part > nearest_part) continue;
    nearest_part = part;
    nearest = i;
  }
  return nearest;
}

bool CurveEditor::add(const Eigen::Vector2d& place) {
  if (points_.size() >= kCurvePointsMax) return false;
  TransferCurve::Point point = point_at(place.cwiseMax(0).cwiseMin(1));
  for (const TransferCurve::Point& other : points_)
    if (std::abs(place_of(other).x() - place.x()) < kNeighbourGap) return false;
  point.alpha = curve().alpha(point.kappa);  // the point starts on the curve
  const auto after = std::find_if(points_.begin(), points_.end(),
                                  [&](const auto& other) { return other.kappa > point.kappa; });
  begin_drag(static_cast<size_t>(after - points_.begin()));
  points_.insert(after, point);
  drag_to(place);
  return true;
}

bool CurveEditor::remove(size_t index) {
  BURNISH_CHECK(index < points_.size(), "only a point that is there can be removed");
  if (points_.size() == 1) return false;
  points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(index));
  dragged_.reset();
  return true;
}

void CurveEditor::drag_to(const Eigen::Vector2d& place) {
  BURNISH_CHECK(dragged_ && *dragged_ < points_.size(), "a drag begins at a point");
  const size_t i = *dragged_;
  double left = 0, right = 1;
  if (i > 0) left = place_of(points_[i - 1]).x() + kNeighbourGap;
  if (i + 1 < points_.size()) right = place_of(points_[i + 1]).x() - kNeighbourGap;
  const double x = left <= right ? std::clamp(place.x(), left, right) : place_of(points_[i]).x();
  double low = kFidelityMin, high = alpha_max_;
  for (size_t other = 0; other < points_.size(); ++other) {
    if (other == i) continue;
    low = std::max(low, points_[other].alpha / kCurveContrastMax * (1 + 1e-9));
    high = std::min(high, points_[other].alpha * kCurveContrastMax * (1 - 1e-9));
  }
  const TransferCurve::Point wanted = point_at({x, std::clamp(place.y(), 0.0, 1.0)});
  points_[i] = {wanted.kappa, std::clamp(wanted.alpha, low, std::max(low, high))};
}

double CurveEditor::fidelity() const {
  double logs = 0;
  for (const TransferCurve::Point& point : points_) logs += std::log(point.alpha);
  return std::exp(logs / static_cast<double>(points_.size()));
}

void CurveEditor::set_fidelity(double alpha) {
  double factor = alpha / fidelity();
  for (const TransferCurve::Point& point : points_)
    factor = std::clamp(factor, kAlphaMin / point.alpha, kAlphaMax / point.alpha);
  for (TransferCurve::Point& point : points_)
    point.alpha = std::clamp(point.alpha * factor, kAlphaMin, kAlphaMax);
}

}  // namespace burnish
