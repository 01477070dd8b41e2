#include "client/model/view/viewport.h"

#include <algorithm>
#include <utility>

#include "client/model/view/zoom.h"
#include "client/scene/likely_up.h"
#include "client/tools/colours.h"
#include "client/tools/lasso.h"

namespace burnish {

using Eigen::Vector2d;

// The camera.

static constexpr double kHomeAzimuth = 25, kHomeElevation = 20;  // degrees
static constexpr double kFocusNearer = 0.5;                      // of the distance

void Viewport::frame_all() {
  camera = burnish::frame_all(camera, box_, size_.aspect());
  framed_ = camera;
}

void Viewport::set_size(const ImageSize& size) {
  if (std::exchange(size_, size) == size || !framed_) return;
  framed_->scene_radius = camera.scene_radius;  // it changes in every picture
  if (framed_ == camera) frame_all();
}

void Viewport::turn(double azimuth_degrees, double elevation_degrees) {
  camera = turned(camera, azimuth_degrees, elevation_degrees);
}

void Viewport::go_home() {
  camera.azimuth_degrees = kHomeAzimuth;
  camera.elevation_degrees = kHomeElevation;
  frame_all();
}

void Viewport::set_up(UpAxis up) {
  camera.up = up;
  frame_all();
}

void Viewport::show_from(StandardView view) {
  camera = seen_from(camera, view);
  frame_all();
}

void Viewport::add_bookmark() {
  if (bookmarks.size() < kBookmarksMax) bookmarks.push_back(camera);
}

void Viewport::focus() {
  if (menu && menu->point) {
    camera.target = *menu->point;
  } else if (hover_) {
    camera.target = hover_->displaced;
  }
}

void Viewport::focus_nearer(const Document& document) {
  if (pointer_) look_at(*pointer_, document);
  if (!hover_) return;
  focus();
  const Eigen::Vector2d middle(0.5 * size_.width, 0.5 * size_.height);
  camera = zoomed_at(camera, size_, middle, kFocusNearer);
}

// The pointer's events, until update() takes them.

static constexpr double kDegreesPerPixel = 0.4;
static constexpr double kLampPerPixel = 1.0 / 200;  // of the ball's radius
static constexpr int kMovesPerPictureMax = 4;
static constexpr double kDoubleClickMs = 400;
static constexpr double kDoubleClickPixels = 6;
static constexpr double kClickPixels = 4;  // from which on it is a drag

static BrushMode mode_of(const Modifiers& modifiers) {
  if (modifiers.control) return BrushMode::kInvert;
  return modifiers.shift ? BrushMode::kRestore : BrushMode::kPaint;
}

void Viewport::press(PointerButton button, const Modifiers& modifiers, const Vector2d& pixel) {
  pointer_ = pixel;
  menu.reset();
  right_click_.reset();
  if (gesture_ == Gesture::kRadius || gesture_ == Gesture::kStrength) {  // a click ends these
    gesture_ = Gesture::kIdle;
    return;
  }
  if (gesture_ != Gesture::kIdle) return;
  held_ = button;
  if (takes_axes(button, pixel)) return;
  gesture_ = gesture_of(button, modifiers);
  if (gesture_ == Gesture::kLasso) lasso_ = {pixel};
  if (gesture_ == Gesture::kPan && button == PointerButton::kRight && paints_) right_click_ = pixel;
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

/// Returns whether a press of the right button is still a click, for a hand may tremble.
bool Viewport::is_click(const Vector2d& pixel) {
  if (!right_click_) return false;
  if ((pixel - *right_click_).norm() < kDoubleClickPixels) return true;
  pointer_ = std::exchange(right_click_, std::nullopt);  // the drag began there
  return false;
}

void Viewport::move(const Vector2d& pixel) {
  if (pointer_ == pixel || is_click(pixel)) return;
  const Vector2d by = pixel - pointer_.value_or(pixel);
  pointer_ = pixel;
  if (pressed_view_ && (pixel - drag_from_).norm() < kClickPixels * ratio()) return;
  pressed_view_.reset();
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
    turn(-kDegreesPerPixel * by.x(), kDegreesPerPixel * by.y());
  }
}

void Viewport::release(PointerButton button) {
  if (gesture_ == Gesture::kIdle || button != held_) return;
  if (gesture_ == Gesture::kRadius || gesture_ == Gesture::kStrength) return;
  if (gesture_ == Gesture::kStroke)
    events_.push_back({Event::Kind::kRelease, pointer_.value_or(Vector2d::Zero())});
  if (gesture_ == Gesture::kLasso) lasso_is_drawn_ = true;
  if (right_click_) menu_asked_ = std::exchange(right_click_, std::nullopt);
  gesture_ = Gesture::kIdle;
  if (const auto view = std::exchange(pressed_view_, {})) show_from(*view);
}

// The scale bar and the axes.

std::optional<ScaleBar> Viewport::scale_bar() const {
  if (!options.scale_bar || !paints_) return std::nullopt;
  return burnish::scale_bar(camera, size_, ratio());
}

std::optional<AxesGizmo> Viewport::axes() const {
  if (!options.axes || !paints_) return std::nullopt;
  return axes_gizmo(camera, size_, ratio());
}

std::optional<UpAxis> Viewport::pointed_axis() const {
  const auto gizmo = axes();
  if (!gizmo || !pointer_ || (is_busy() && !pressed_view_)) return std::nullopt;
  const AxisEnd* const end = end_at(*gizmo, *pointer_);
  return end ? std::optional(end->axis) : std::nullopt;
}

bool Viewport::is_over_axes() const {
  const auto gizmo = axes();
  return gizmo && pointer_ && covers(*gizmo, *pointer_);
}

// A drag turns the view, a click on an end shows another one.
bool Viewport::takes_axes(PointerButton button, const Vector2d& pixel) {
  if (button != PointerButton::kLeft || !is_over_axes()) return false;
  const auto gizmo = axes();
  const AxisEnd* const end = end_at(*gizmo, pixel);
  if (end) pressed_view_ = end->view;
  drag_from_ = pixel;
  gesture_ = Gesture::kTurn;
  return true;
}

// The pointer, what is under it, and its gestures.

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
  const ScanInfo& scan = document.scan().scan;
  begin(document.box(), likely_up(document.box(), scan.unit, scan.format));
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
  const bool was_busy = is_busy() || lasso_wish || menu;
  menu.reset();
  right_click_.reset();
  lasso_.clear();
  lasso_wish.reset();
  gesture_ = Gesture::kIdle;
  pressed_view_.reset();
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
  document.set_curvature_ends(options.curvature);
  if (std::exchange(value_changes_, false)) drag_value(document);
  if (std::exchange(lasso_is_drawn_, false)) end_lasso(document);
  for (const Event& event : std::exchange(events_, {})) paint(event, document);
  if (std::exchange(is_focus_asked_, false)) focus_nearer(document);
  if (gesture_ == Gesture::kIdle && is_over_axes()) {
    hover_.reset();
    looked_.reset();
  } else if (pointer_ && gesture_ != Gesture::kTurn && gesture_ != Gesture::kPan) {
    look_at(*pointer_, document);
  }
  if (const auto pixel = std::exchange(menu_asked_, std::nullopt))
    menu = PictureMenu{*pixel, hover_ ? std::optional(hover_->displaced) : std::nullopt};
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
  if (hover_) last_hover_ = hover_->original;
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

// A surface without a session.

void Viewport::begin(const Eigen::AlignedBox3d& box, UpAxis up) {
  reset(box);
  paints_ = false;
  camera = {.up = up};
  go_home();
}

void Viewport::take_over(const Document& document) {
  paints_ = true;
  box_ = document.box();
  events_.clear();
}

void Viewport::update(const Eigen::AlignedBox3d& box) {
  camera = with_depth_of(camera, box);
  events_.clear();
}

void Viewport::reset(const Eigen::AlignedBox3d& box) {
  gesture_ = Gesture::kIdle;
  pressed_view_.reset();
  value_changes_ = false;
  events_.clear();
  lasso_.clear();
  lasso_wish.reset();
  lasso_is_drawn_ = false;
  bookmarks.clear();
  menu.reset();
  right_click_.reset();
  menu_asked_.reset();
  measure_mode = false;
  leave();
  last_hover_.reset();
  sent_ring_.reset();
  box_ = box;
}

// The style of pictures.

static const Vec3f kMirroredRing(0.75f, 0.75f, 0.75f);  // sRGB

static Colouring colouring_of(ColourBy colour) {
  switch (colour) {
    case ColourBy::kBeta:
    case ColourBy::kCurvature:
      return Colouring::kCells;
    case ColourBy::kDisplacement:
      return Colouring::kDisplacement;
    case ColourBy::kScan:
      return Colouring::kScan;
    case ColourBy::kNothing:
      break;
  }
  return Colouring::kClay;
}

DrawStyle Viewport::style(const Document& document) const {
  DrawStyle style;
  style.flat = options.flat;
  style.wireframe = options.wireframe;
  style.colouring = colouring_of(document.colour());
  style.displacement = options.displacement;
  style.original = hold_original;
  style.lighting = options.lighting;
  style.split = options.split ? options.split_at : 0;
  style.faded = document.link() == LinkState::kLost || document.link() == LinkState::kEnded;
  const BrushTool& brush = document.brush();
  const double beta = brush.is_drawing() ? brush.stroke().brush.beta : brush.brush.beta;
  style.tint = blue_to_red(signed_part_of_beta(beta));
  const auto curve = static_cast<size_t>(brush.brush.curve);
  if (curve > 0 && curve <= document.palette().curves.size())
    style.tint = colour_of_hex(document.palette().curves[curve - 1].colour);
  if (hides_rings) return style;
  if (hover_ && pointer_ && !navigate_mode && !measure_mode && !document.is_viewer()) {
    const Vec3d& at = hover_->original;
    style.rings.push_back({at, brush.brush.radius, Vec3f(1, 1, 1)});
    if (document.mirror)
      style.rings.push_back({mirrored(at, *document.mirror), brush.brush.radius, kMirroredRing});
  }
  for (const PresentUser& user : document.people().present)
    if (user.ring && user.connection != document.welcome().connection)
      style.rings.push_back({user.ring->centre, user.ring->radius, colour_of_hex(user.colour)});
  return style;
}

}  // namespace burnish
