#include "client/tools/brush_tool.h"

#include <algorithm>
#include <cmath>

#include "client/tools/pen_pressure.h"
#include "common/base/check.h"
#include "common/base/limits.h"

namespace burnish {

static constexpr double kRadiusMin = 1e-4;  // of the scan's diagonal
static constexpr double kRadiusMax = 0.5;
static constexpr double kOnDab = 1e-6;        // of the spacing, as dab_centres()
static constexpr double kPointSpacing = 0.1;  // of the radius; finer than dabs

double painted_value(const Brush& brush, BrushMode mode) {
  if (mode == BrushMode::kRestore) return brush.keeping_value();
  const double middle = brush.edges ? 0.5 : 1;
  if (mode == BrushMode::kInvert)
    return std::clamp(2 * middle - brush.beta, kBetaMin, brush.value_max());
  return brush.beta;
}

void BrushTool::scale_radius(double factor, double diagonal) {
  set_radius(brush.radius * factor, diagonal);
}

void BrushTool::set_radius(double radius, double diagonal) {
  brush.radius = std::clamp(radius, kRadiusMin * diagonal, kRadiusMax * diagonal);
}

void BrushTool::begin(BrushMode mode, const Vec3d& point, double pressure) {
  gesture_brush_ = brush;
  gesture_brush_.beta = painted_value(brush, mode);
  go_on(point, pressure);
}

void BrushTool::go_on(const Vec3d& point, double pressure) {
  stroke_ = Stroke{gesture_brush_, {point}};
  stroke_->brush.strength = strength_under(gesture_brush_.strength, pressure);
  pressure_ = pressure;
  length_ = 0;
  taken_ = 0;
}

std::optional<Vec3d> BrushTool::extend(const Vec3d& point, double pressure) {
  BURNISH_CHECK(is_drawing(), "a stroke is begun before it is extended");
  const double step = (point - stroke_->path.back()).norm();
  if (step < kPointSpacing * stroke_->brush.radius) return std::nullopt;
  if (length_ + step > spacing() * (kStrokeDabsMax - 2)) return point;
  if (needs_another_stroke(pressure_, pressure))
    if (const auto dab = next_dab(point)) return dab;
  length_ += step;
  stroke_->path.push_back(point);
  return std::nullopt;
}

// Returns the first dab on the way to the point, if there is one.
std::optional<Vec3d> BrushTool::next_dab(const Vec3d& point) const {
  const Vec3d& last = stroke_->path.back();
  const double step = (point - last).norm();
  double until = spacing() - std::fmod(length_, spacing());
  if (until < kOnDab * spacing()) until += spacing();  // the stroke ends on a dab
  if (until > step) return std::nullopt;
  return last + (until / step) * (point - last);
}

std::vector<Vec3d> BrushTool::take_new_points() {
  BURNISH_CHECK(is_drawing(), "only a stroke has points");
  std::vector<Vec3d> points(stroke_->path.begin() + taken_, stroke_->path.end());
  taken_ = stroke_->path.size();
  return points;
}

Stroke BrushTool::end() {
  BURNISH_CHECK(is_drawing(), "a stroke is begun before it is ended");
  Stroke stroke = std::move(*stroke_);
  stroke_.reset();
  return stroke;
}

}  // namespace burnish
