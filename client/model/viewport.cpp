#include "client/model/viewport.h"

#include <algorithm>
#include <utility>

#include "client/model/zoom.h"
#include "client/tools/lasso.h"

namespace burnish {

using Eigen::Vector2d;

void Viewport::wheel(const Vector2d& pixel, double steps) {
  ZoomPlace place{pixel};
  if (hover_) place.surface = hover_->displaced;
  camera = zoomed_by_wheel(camera, size_, place, steps, box_);
}

void Viewport::leave() {
  if (is_busy()) return;
  pointer_.reset();
  hover_.reset();
  looked_.reset();
}

void Viewport::begin(const Document& document) {
  begin(document.box());
  paints_ = true;
}

void Viewport::begin_radius(const Document& document) {
  if (is_busy() || !pointer_) return;
  gesture_ = Gesture::kRadius;
  drag_from_ = *pointer_;
  value_from_ = document.brush().brush.radius;
}

void Viewport::begin_strength(const Document& document) {
  if (is_busy() || !pointer_) return;
  gesture_ = Gesture::kStrength;
  drag_from_ = *pointer_;
  value_from_ = document.brush().brush.strength;
}

bool Viewport::cancel(Document& document) {
  if (gesture_ == Gesture::kRadius) document.brush().brush.radius = value_from_;
  if (gesture_ == Gesture::kStrength) document.brush().brush.strength = value_from_;
  if (document.brush().is_drawing()) document.cancel_stroke();
  const bool was_busy = is_busy() || lasso_wish;
  lasso_.clear();
  lasso_wish.reset();
  gesture_ = Gesture::kIdle;
  value_changes_ = false;
  events_.clear();
  return was_busy;
}

void Viewport::drag_value(Document& document) {
  constexpr double kStrengthPerPixel = 0.004;
  const double by = pointer_->x() - drag_from_.x();
  if (gesture_ == Gesture::kRadius)
    document.brush().set_radius(value_from_ + by * pixel_length(camera, size_),
                                document.diagonal());
  if (gesture_ == Gesture::kStrength)
    document.brush().brush.strength = std::clamp(value_from_ + by * kStrengthPerPixel, 0.01, 1.0);
}

std::optional<SurfaceHit> Viewport::hit_at(const Document& document, const Vector2d& pixel) const {
  const Eigen::Vector2i at = pixel.array().floor().cast<int>();
  if (at.minCoeff() < 0 || at.x() >= size_.width || at.y() >= size_.height) return std::nullopt;
  return document.surface().hit_at(camera, size_, at, shows_original(pixel));
}

bool Viewport::shows_original(const Vector2d& pixel) const {
  return hold_original ||
         (options.split && pixel.x() < split_column(options.split_at, size_.width));
}

void Viewport::update(Document& document) {
  camera = with_depth_of(camera, document.box());
  if (std::exchange(value_changes_, false)) drag_value(document);
  if (std::exchange(lasso_is_drawn_, false)) end_lasso(document);
  for (const Event& event : std::exchange(events_, {})) paint(event, document);
  if (std::exchange(is_focus_asked_, false)) focus_nearer(document);
  if (pointer_ && gesture_ != Gesture::kTurn && gesture_ != Gesture::kPan)
    look_at(*pointer_, document);
  send_ring(document);
}

Status Viewport::draw(PageRenderer& renderer, const Document& document) const {
  return renderer.draw(camera, size_, style(document), document.surface().patches());
}

// Finds the surface under the pointer again, even a still one, when the camera or the surface
// moves.
void Viewport::look_at(const Vector2d& pixel, const Document& document) {
  const Look look{pixel, camera, size_, document.picture_changes(), shows_original(pixel)};
  if (looked_ == look) return;
  hover_ = hit_at(document, pixel);
  looked_ = look;
}

// Paints the surface under the pointer. Beside the surface nothing happens.
void Viewport::paint(const Event& event, Document& document) {
  if (event.kind == Event::Kind::kRelease) {
    if (document.brush().is_drawing()) document.end_stroke();
    return;
  }
  look_at(event.pixel, document);
  if (!hover_) return;
  if (measure_mode && !document.brush().is_drawing()) {
    if (event.kind == Event::Kind::kPress)
      document.measuring().ruler.put({hover_->displaced, hover_->original});
    return;
  }
  if (document.brush().is_drawing()) {
    document.extend_stroke(hover_->original, event.pressure);
  } else if (event.kind == Event::Kind::kPress) {
    document.begin_stroke(event.mode, hover_->original, event.pressure);
  }
}

void Viewport::end_lasso(Document& document) {
  static constexpr size_t kPointsMin = 3;
  const std::vector<Vector2d> line = std::exchange(lasso_, {});
  const LassoWish wish = std::exchange(lasso_wish, {}).value_or(LassoWish{});
  if (line.size() >= kPointsMin)
    document.protect({lasso_in_picture(camera, size_, line, wish.through), wish.release});
}

void Viewport::send_ring(Document& document) {
  std::optional<BrushRing> ring;
  if (hover_ && pointer_ && !navigate_mode && !measure_mode)
    ring = BrushRing{hover_->original, document.brush().brush.radius};
  if (ring == sent_ring_) return;
  document.move_ring(ring);
  sent_ring_ = ring;
}

}  // namespace burnish
