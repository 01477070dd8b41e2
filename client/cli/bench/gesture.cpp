#include "client/cli/bench/gesture.h"

#include <algorithm>

#include "common/edit/edit_id.h"

namespace burnish {

using std::chrono::milliseconds;

static constexpr milliseconds kGestureMin{500}, kGestureMax{1500};
static constexpr double kRadius = 0.02;  // of the box's diagonal
static constexpr size_t kPathPointsMax = 300;

static double diagonal_of(const LoadSurface& surface) {
  Vec3d least = surface.points.at(0), greatest = least;
  for (const Vec3d& point : surface.points) {
    least = least.cwiseMin(point);
    greatest = greatest.cwiseMax(point);
  }
  return (greatest - least).norm();
}

Gestures::Gestures(std::shared_ptr<const LoadSurface> surface, const LoadMix& mix, uint32_t seed)
    : surface_(std::move(surface)),
      mix_(mix),
      random_(seed),
      radius_(kRadius * diagonal_of(*surface_)) {}

void Gestures::begin(Time now) {
  std::uniform_int_distribution<int64_t> length(kGestureMin.count(), kGestureMax.count());
  std::uniform_real_distribution<double> beta(0, 2);
  activity_ = mix_.choose(random_);
  end_ = now + milliseconds(length(random_));
  edit_id_ = random_id();
  beta_ = beta(random_);
  beta_step_ = (beta(random_) - 1) / 60;
  point_ = random_() % surface_->points.size();
  stroke_ = {{.radius = radius_, .strength = 0.5, .beta = beta_}, {}};
}

void Gestures::advance(Time now, SessionLink& session) {
  if (now >= end_) {
    end(session);
    begin(now);
  }
  if (activity_ == Activity::kDrag) {
    beta_ = std::clamp(beta_ + beta_step_, 0.0, 3.0);
    session.preview(edit_id_, SetGradientScale{beta_});
  } else if (activity_ == Activity::kPaint) {
    advance_stroke(session);
  }
}

void Gestures::advance_stroke(SessionLink& session) {
  const auto point = next_point();
  if (!point || stroke_.path.size() >= kPathPointsMax) return;
  stroke_.path.push_back(*point);
  session.preview(edit_id_, Stroke{stroke_.brush, {*point}});
  session.move_brush(BrushRing{*point, radius_});
}

// Goes to the next vertex: those of a page mostly lie side by side.
std::optional<Vec3d> Gestures::next_point() {
  point_ = (point_ + 1) % surface_->points.size();
  const Vec3d& point = surface_->points[point_];
  if (!stroke_.path.empty() && (point - stroke_.path.back()).norm() > 2 * radius_)
    return std::nullopt;
  return point;
}

void Gestures::end(SessionLink& session) {
  if (activity_ == Activity::kDrag) {
    apply(session, {edit_id_, SetGradientScale{beta_}});
  } else if (activity_ == Activity::kPaint && !stroke_.path.empty()) {
    apply(session, {edit_id_, stroke_});
  }
  activity_ = Activity::kDraw;
}

void Gestures::apply(SessionLink& session, Edit edit) {
  const std::string id = edit.id;
  if (session.apply({std::move(edit)}).is_ok()) applied_.push_back(id);
}

}  // namespace burnish
