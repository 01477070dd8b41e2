#include "client/tools/brush_tool.h"

#include <algorithm>

#include "common/base/check.h"
#include "common/base/limits.h"

namespace burnish {

static constexpr double kRadiusMin = 1e-4;  // of the scan's diagonal
static constexpr double kRadiusMax = 0.5;
static constexpr double kPointSpacing = 0.1;  // of the radius; finer than dabs

double painted_beta(double beta, BrushMode mode) {
  if (mode == BrushMode::kRestore) return 1;
  if (mode == BrushMode::kInvert) return std::clamp(2 - beta, kBetaMin, kBetaMax);
  return beta;
}

void BrushTool::scale_radius(double factor, double diagonal) {
  set_radius(brush.radius * factor, diagonal);
}

void BrushTool::set_radius(double radius, double diagonal) {
  brush.radius = std::clamp(radius, kRadiusMin * diagonal, kRadiusMax * diagonal);
}

void BrushTool::begin(BrushMode mode, const Vec3d& point) {
  Brush stroke_brush = brush;
  stroke_brush.beta = painted_beta(brush.beta, mode);
  go_on(stroke_brush, point);
}

void BrushTool::go_on(const Brush& stroke_brush, const Vec3d& point) {
  stroke_ = Stroke{stroke_brush, {point}};
  length_ = 0;
  taken_ = 0;
}

bool BrushTool::extend(const Vec3d& point) {
  BURNISH_CHECK(is_drawing(), "a stroke is begun before it is extended");
  const double step = (point - stroke_->path.back()).norm();
  const double radius = stroke_->brush.radius;
  if (step < kPointSpacing * radius) return true;
  if (length_ + step > kDabSpacing * radius * (kStrokeDabsMax - 2)) return false;
  length_ += step;
  stroke_->path.push_back(point);
  return true;
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
