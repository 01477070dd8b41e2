#include "common/edit/transfer_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/base/limits.h"
#include "common/base/parse_number.h"
#include "common/base/text.h"

namespace burnish {

static Status check_range(const char* what, double x, double min, double max) {
  if (x >= min && x <= max) return Status::ok();  // false for NaN
  return invalid_argument(std::string(what) + " " + shortest_text(x) + " is outside " +
                          shortest_text(min) + ".." + shortest_text(max));
}

Status check_alpha(double alpha) {
  return check_range("alpha", alpha, kAlphaMin, kAlphaMax);
}
Status check_beta(double beta) {
  return check_range("beta", beta, kBetaMin, kBetaMax);
}

TransferCurve::TransferCurve(std::vector<Point> points) : points_(std::move(points)) {
  for (const Point& point : points_) logs_.push_back(std::log(point.alpha));
}

TransferCurve::TransferCurve(double alpha) : TransferCurve(std::vector<Point>{{0.0, alpha}}) {
  BURNISH_CHECK(check_alpha(alpha).is_ok(), "alpha is checked at the edge");
}

static Status check_point(size_t i, const TransferCurve::Point& point) {
  const std::string where = "curve point " + std::to_string(i + 1);
  RETURN_IF_ERROR(
      check_range("kappa", point.kappa, -kCurveKappaMagnitudeMax, kCurveKappaMagnitudeMax)
          .with_context(where));
  return check_alpha(point.alpha).with_context(where);
}

Result<TransferCurve> TransferCurve::create(std::vector<Point> points) {
  if (points.empty() || points.size() > kCurvePointsMax)
    return invalid_argument("a transfer curve has 1 to " + std::to_string(kCurvePointsMax) +
                            " points, not " + std::to_string(points.size()));
  for (size_t i = 0; i < points.size(); ++i) {
    RETURN_IF_ERROR(check_point(i, points[i]));
    if (i > 0 && !(points[i].kappa > points[i - 1].kappa))
      return invalid_argument(
          "curve point " + std::to_string(i + 1) + ": kappa " + shortest_text(points[i].kappa) +
          " must be above the kappa before it, " + shortest_text(points[i - 1].kappa));
  }
  TransferCurve curve(std::move(points));
  if (curve.contrast() > kCurveContrastMax * (1 + 1e-12))
    return invalid_argument("curve contrast (largest over least alpha) " +
                            shortest_text(curve.contrast()) + " is above " +
                            shortest_text(kCurveContrastMax));
  return curve;
}

static Result<double> parse_coordinate(std::string_view text, std::string_view point) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  if (const auto x = parse_number<double>(text)) return *x;
  return invalid_argument("curve point '" + std::string(point) +
                          "' is not kappa:alpha, e.g. -5:50");
}

static std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

static Result<TransferCurve::Point> parse_point(std::string_view text) {
  const size_t colon = text.find(':');
  const std::string_view kappa = trimmed(text.substr(0, std::min(colon, text.size())));
  const std::string_view alpha =
      colon == std::string_view::npos ? "" : trimmed(text.substr(colon + 1));
  TransferCurve::Point point{};
  ASSIGN_OR_RETURN(point.kappa, parse_coordinate(kappa, text));
  ASSIGN_OR_RETURN(point.alpha, parse_coordinate(alpha, text));
  return point;
}

Result<TransferCurve> TransferCurve::parse(std::string_view text) {
  std::vector<Point> points;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    ASSIGN_OR_RETURN(Point point, parse_point(trimmed(text.substr(begin, end - begin))));
    points.push_back(point);
    begin = end + 1;
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.kappa < b.kappa; });
  return create(std::move(points));
}

double TransferCurve::alpha(double kappa) const {
  const auto right = std::upper_bound(points_.begin(), points_.end(), kappa,
                                      [](double k, const Point& p) { return k < p.kappa; });
  if (right == points_.begin()) return points_.front().alpha;
  if (right == points_.end()) return points_.back().alpha;
  const auto left = right - 1;
  const double t = (kappa - left->kappa) / (right->kappa - left->kappa);
  return std::exp(logs_[left - points_.begin()] * (1 - t) + logs_[right - points_.begin()] * t);
}

double TransferCurve::contrast() const {
  const auto [least, largest] =
      std::minmax_element(points_.begin(), points_.end(),
                          [](const Point& a, const Point& b) { return a.alpha < b.alpha; });
  return largest->alpha / least->alpha;
}

std::string TransferCurve::to_string() const {
  std::string text;
  for (const Point& point : points_) {
    if (!text.empty()) text += ',';
    text += shortest_text(point.kappa) + ":" + shortest_text(point.alpha);
  }
  return text;
}

}  // namespace burnish
