#include "client/model/viewport.h"

#include <algorithm>
#include <cmath>

#include "client/tools/lasso.h"

namespace burnish {

using Eigen::Vector2d;

static constexpr double kDegreesPerPixel = 0.4;
static constexpr double kZoomPerStep = 0.88;
static constexpr int kMovesPerPictureMax = 4;
static constexpr double kDiagonalsAwayMax = 6;

static BrushMode mode_of(const Modifiers& modifiers) {
  if (modifiers.control) return BrushMode::kInvert;
  return modifiers.shift ? BrushMode::kRestore : BrushMode::kPaint;
}

void Viewport::press(PointerButton button, const Modifiers& modifiers, const Vector2d& pixel) {
  pointer_ = pixel;
  if (gesture_ == Gesture::kRadius || gesture_ == Gesture::kStrength) {  // a click ends these
    gesture_ = Gesture::kIdle;
    return;
  }
  if (gesture_ != Gesture::kIdle) return;
  held_ = button;
  const bool turns = button == PointerButton::kMiddle ||
                     (button == PointerButton::kLeft && (modifiers.alt || navigate_mode));
  if (button == PointerButton::kRight || (turns && modifiers.shift)) {
    gesture_ = Gesture::kPan;
  } else if (turns) {
    gesture_ = Gesture::kTurn;
  } else if (lasso_wish) {
    gesture_ = Gesture::kLasso;
    lasso_ = {pixel};
  } else {
    gesture_ = Gesture::kStroke;
    events_.push_back({Event::Kind::kPress, pixel, mode_of(modifiers)});
  }
}

void Viewport::move(const Vector2d& pixel) {
  if (pointer_ == pixel) return;
  const Vector2d by = pixel - pointer_.value_or(pixel);
  pointer_ = pixel;
  if (gesture_ == Gesture::kTurn || gesture_ == Gesture::kPan) drag_camera(by);
  if (gesture_ == Gesture::kRadius || gesture_ == Gesture::kStrength) value_changes_ = true;
  if (gesture_ == Gesture::kLasso) lasso_.push_back(pixel);
  if (gesture_ != Gesture::kStroke) return;
  // Each move costs a look at the surface, so only some of the moves between two pictures count.
  const auto moves = std::count_if(events_.begin(), events_.end(), [](const Event& event) {
    return event.kind == Event::Kind::kMove;
  });
  if (moves >= kMovesPerPictureMax && events_.back().kind == Event::Kind::kMove) events_.pop_back();
  events_.push_back({Event::Kind::kMove, pixel});
}

void Viewport::drag_camera(const Vector2d& by) {
  if (gesture_ == Gesture::kPan) {
    camera = panned(camera, size_, by);
  } else {
    camera = turned(camera, -kDegreesPerPixel * by.x(), kDegreesPerPixel * by.y());
  }
}

void Viewport::release(PointerButton button) {
  if (gesture_ == Gesture::kIdle || button != held_) return;
  if (gesture_ == Gesture::kRadius || gesture_ == Gesture::kStrength) return;
  if (gesture_ == Gesture::kStroke)
    events_.push_back({Event::Kind::kRelease, pointer_.value_or(Vector2d::Zero())});
  if (gesture_ == Gesture::kLasso) lasso_is_drawn_ = true;
  gesture_ = Gesture::kIdle;
}

// Moves towards the surface under the pointer: the eye never passes it. Stays where the scan can
// still be seen.
void Viewport::wheel(const Vector2d& pixel, double steps) {
  Camera from = hover_ ? with_target_as_deep_as(camera, hover_->displaced) : camera;
  from = zoomed_at(from, size_, pixel, std::pow(kZoomPerStep, steps));
  const bool is_lost = from.distance > kDiagonalsAwayMax * diagonal_;
  if (steps > 0 || !is_lost) camera = from;
}

void Viewport::leave() {
  if (is_busy()) return;
  pointer_.reset();
  hover_.reset();
  looked_.reset();
}

void Viewport::begin(const Document& document) {
  gesture_ = Gesture::kIdle;
  value_changes_ = false;
  events_.clear();
  lasso_.clear();
  lasso_wish.reset();
  lasso_is_drawn_ = false;
  bookmarks.clear();
  leave();
  sent_ring_.reset();
  diagonal_ = document.diagonal();
  camera = {.azimuth_degrees = 25, .elevation_degrees = 20};
  frame_all(document);
}

void Viewport::frame_all(const Document& document) {
  camera = burnish::frame_all(camera, document.box(), size_.aspect());
}

void Viewport::focus() {
  if (hover_) camera.target = hover_->displaced;
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
  if (document.brush().is_drawing()) {
    document.extend_stroke(hover_->original);
  } else if (event.kind == Event::Kind::kPress) {
    document.begin_stroke(event.mode, hover_->original);
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
  if (hover_ && pointer_ && !navigate_mode)
    ring = BrushRing{hover_->original, document.brush().brush.radius};
  if (ring == sent_ring_) return;
  document.move_ring(ring);
  sent_ring_ = ring;
}

}  // namespace burnish
