#include <algorithm>
#include <utility>

#include "client/model/viewport.h"

namespace burnish {

using Eigen::Vector2d;

static constexpr double kDegreesPerPixel = 0.4;
static constexpr double kLampPerPixel = 1.0 / 200;  // of the ball's radius
static constexpr int kMovesPerPictureMax = 4;
static constexpr double kDoubleClickMs = 400;
static constexpr double kDoubleClickPixels = 6;

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
  gesture_ = gesture_of(button, modifiers);
  if (gesture_ == Gesture::kLasso) lasso_ = {pixel};
  if (gesture_ == Gesture::kStroke)
    events_.push_back({Event::Kind::kPress, pixel, mode_of(modifiers), pressure});
  if (gesture_ == Gesture::kTurn && is_second_press(button, pixel)) is_focus_asked_ = true;
}

Viewport::Gesture Viewport::gesture_of(PointerButton button, const Modifiers& modifiers) const {
  const bool turns =
      button == PointerButton::kMiddle ||
      (button == PointerButton::kLeft && (modifiers.alt || navigate_mode || !paints_));
  if (button == PointerButton::kRight && modifiers.control && modifiers.shift)
    return Gesture::kLight;
  if (button == PointerButton::kRight || (turns && modifiers.shift)) return Gesture::kPan;
  if (turns) return Gesture::kTurn;
  return lasso_wish ? Gesture::kLasso : Gesture::kStroke;
}

bool Viewport::is_second_press(PointerButton button, const Vector2d& pixel) {
  const Press press{button, pixel, clock()};
  const auto last = std::exchange(last_press_, press);
  const bool is_second = last && last->button == button &&
                         (pixel - last->pixel).norm() < kDoubleClickPixels &&
                         ms_between(last->when, press.when) < kDoubleClickMs;
  if (is_second) last_press_.reset();
  return is_second;
}

void Viewport::move(const Vector2d& pixel) {
  if (pointer_ == pixel) return;
  const Vector2d by = pixel - pointer_.value_or(pixel);
  pointer_ = pixel;
  if (gesture_ == Gesture::kTurn || gesture_ == Gesture::kPan) drag_camera(by);
  if (gesture_ == Gesture::kLight)
    options.lighting =
        with_lamp_at(options.lighting,
                     lamp_on_ball(options.lighting) + kLampPerPixel * Vector2d(by.x(), -by.y()));
  if (gesture_ == Gesture::kRadius || gesture_ == Gesture::kStrength) value_changes_ = true;
  if (gesture_ == Gesture::kLasso) lasso_.push_back(pixel);
  if (gesture_ != Gesture::kStroke) return;
  // Each move costs a look at the surface, so only some of the moves between two pictures count.
  const auto moves = std::count_if(events_.begin(), events_.end(), [](const Event& event) {
    return event.kind == Event::Kind::kMove;
  });
  if (moves >= kMovesPerPictureMax && events_.back().kind == Event::Kind::kMove) events_.pop_back();
  events_.push_back({Event::Kind::kMove, pixel, BrushMode::kPaint, pressure});
}

void Viewport::drag_camera(const Vector2d& by) {
  last_press_.reset();  // a drag is not a click
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

}  // namespace burnish
