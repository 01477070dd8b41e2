#pragma once

#include <optional>
#include <vector>

#include "client/model/documents/document.h"
#include "client/scene/axes_gizmo.h"
#include "client/scene/camera.h"
#include "client/scene/page_renderer.h"
#include "client/scene/scale_bar.h"
#include "client/scene/standard_view.h"
#include "common/base/clock.h"

namespace burnish {

inline constexpr size_t kBookmarksMax = 36;

enum class PointerButton { kLeft, kMiddle, kRight };

struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
};

/// Settings of how the surface is shown.
struct ViewOptions {
  bool flat = false;
  bool wireframe = false;
  bool split = false;
  double split_at = 0.5;    ///< part of the width
  ColourEnds displacement;  ///< of its colours, cells
  ColourEnds curvature;     ///< of its colours, parts of the histogram's range
  bool scale_bar = true;    ///< also in pictures that are saved
  bool axes = true;
  Lighting lighting;

  bool operator==(const ViewOptions&) const = default;
};

/// The next drag of the left button draws a lasso.
struct LassoWish {
  bool through = false;  ///< also surface that faces away
  bool release = false;  ///< what it holds is no longer protected
};

/// The menu that a click of the right button asks for.
struct PictureMenu {
  Eigen::Vector2d pixel;
  std::optional<Vec3d> point;  ///< of the shown surface there; nothing beside it
};

/// The picture of a document: the camera and the actions of the pointer. It keeps events until
/// update(), which looks at what lies under the pointer. Pixels count from the picture's
/// upper left corner. Needs no window.
class Viewport {
 public:
  Camera camera;
  ViewOptions options;
  bool navigate_mode = false;  ///< the left button turns the view
  bool hold_original = false;  ///< show the original
  bool hides_rings = false;    ///< a picture of the surface alone is wanted
  bool measure_mode = false;   ///< the left button puts the ruler's ends
  double pressure = 1;         ///< of the pen that draws, 0 to 1; 1: a mouse
  double pixel_ratio = 0;      ///< as of scale_bar(); 0: that of a picture for no screen
  std::optional<LassoWish> lasso_wish;
  bool lasso_through = false;                    ///< of the next wish
  std::vector<Camera> bookmarks;                 ///< at most kBookmarksMax
  std::optional<PictureMenu> menu;               ///< until it is closed, or the next press
  Clock clock = std::chrono::steady_clock::now;  ///< tells a double click

  /// A view that shows the whole scan goes on to do so.
  void set_size(const ImageSize& size);
  const ImageSize& size() const { return size_; }

  void press(PointerButton button, const Modifiers& modifiers, const Eigen::Vector2d& pixel);
  void move(const Eigen::Vector2d& pixel);
  void release(PointerButton button);
  void wheel(const Eigen::Vector2d& pixel, double steps);
  void leave();  ///< the pointer has left the picture

  /// Resets for a newly opened document. Keeps only the settings of how surfaces are shown.
  void begin(const Document& document);
  /// Does the same for a surface without a session: all buttons turn or move it.
  void begin(const Eigen::AlignedBox3d& box, UpAxis up);
  /// Goes on with a document that has the same surface. The camera and its drag stay.
  void take_over(const Document& document);
  void frame_all();
  /// Moves the eye around the target: to the right and upwards, degrees.
  void turn(double azimuth_degrees, double elevation_degrees);
  void focus();         ///< turn around the point of the menu, else the one under the pointer
  void add_bookmark();  ///< of this camera, while there is room
  /// Shows the whole scan as at first, without a tilt of the user's.
  void go_home();
  /// Shows the whole scan from the same angles with another axis up.
  void set_up(UpAxis up);
  void show_from(StandardView view);
  void begin_radius(const Document& document);
  void begin_strength(const Document& document);
  /// Cancels the pointer's gesture. Returns false if there was none.
  bool cancel(Document& document);

  /// Handles the pointer's events.
  void update(Document& document);
  void update(const Eigen::AlignedBox3d& box);

  /// Prepares the picture of the document; draw() then draws it. Fails: as the renderer does.
  Status look(Document& document) const {
    return document.look(camera, size_, options.lighting.kind == LightKind::kUnlit);
  }
  Status draw(PageRenderer& renderer, const Document& document) const;

  /// Returns the surface point under the pointer at the last update().
  const std::optional<SurfaceHit>& hover() const { return hover_; }
  /// Returns the point of the original surface that was under the pointer last.
  const std::optional<Vec3d>& last_hover() const { return last_hover_; }
  const std::optional<Eigen::Vector2d>& pointer() const { return pointer_; }
  /// Returns the scale bar and the axes that lie over a session's picture; nothing: they are off.
  std::optional<ScaleBar> scale_bar() const;
  std::optional<AxesGizmo> axes() const;
  /// Returns the end of an axis under the pointer.
  std::optional<UpAxis> pointed_axis() const;
  /// Returns the line of the lasso that is being drawn, in pixels.
  const std::vector<Eigen::Vector2d>& lasso() const { return lasso_; }
  bool is_busy() const { return gesture_ != Gesture::kIdle; }

  DrawStyle style(const Document& document) const;

 private:
  enum class Gesture { kIdle, kStroke, kLasso, kTurn, kPan, kLight, kRadius, kStrength };
  struct Event {
    enum class Kind { kPress, kMove, kRelease } kind;
    Eigen::Vector2d pixel;
    BrushMode mode = BrushMode::kPaint;
    double pressure = 1;
  };

  /// The inputs that decide the result of look_at().
  struct Look {
    Eigen::Vector2d pixel;
    Camera camera;
    ImageSize size;
    uint64_t changes = 0;  // of the drawn surface
    bool original = false;

    bool operator==(const Look&) const = default;
  };

  struct Press {
    PointerButton button;
    Eigen::Vector2d pixel;
    std::chrono::steady_clock::time_point when;
  };

  Gesture gesture_of(PointerButton button, const Modifiers& modifiers) const;
  bool is_second_press(PointerButton button, const Eigen::Vector2d& pixel);
  void focus_nearer(const Document& document);
  void reset(const Eigen::AlignedBox3d& box);
  bool shows_original(const Eigen::Vector2d& pixel) const;
  void look_at(const Eigen::Vector2d& pixel, const Document& document);
  std::optional<SurfaceHit> hit_at(const Document& document, const Eigen::Vector2d& pixel) const;
  void paint(const Event& event, Document& document);
  void end_lasso(Document& document);
  bool takes_axes(PointerButton button, const Eigen::Vector2d& pixel);
  bool is_over_axes() const;
  double ratio() const { return pixel_ratio > 0 ? pixel_ratio : pixel_ratio_of(size_); }
  void drag_camera(const Eigen::Vector2d& by);
  bool is_click(const Eigen::Vector2d& pixel);
  void drag_value(Document& document);
  void send_ring(Document& document);

  ImageSize size_{1, 1};
  std::optional<Camera> framed_;                           // of the last frame_all()
  Eigen::AlignedBox3d box_{Vec3d::Zero(), Vec3d::Ones()};  // of the scan, file units
  bool paints_ = true;                                     // there is a session to paint on
  Gesture gesture_ = Gesture::kIdle;
  PointerButton held_ = PointerButton::kLeft;
  std::optional<Press> last_press_;  // that turned the view
  bool is_focus_asked_ = false;
  std::optional<StandardView> pressed_view_;    // of the end that a click has begun on
  std::optional<Eigen::Vector2d> right_click_;  // of the right button, until the pointer moves
  std::optional<Eigen::Vector2d> menu_asked_;
  std::optional<Eigen::Vector2d> pointer_;
  Eigen::Vector2d drag_from_ = Eigen::Vector2d::Zero();
  double value_from_ = 0;  // radius or strength when its drag began
  bool value_changes_ = false;
  std::vector<Event> events_;  // events of the brush
  std::vector<Eigen::Vector2d> lasso_;
  bool lasso_is_drawn_ = false;
  std::optional<SurfaceHit> hover_;
  std::optional<Vec3d> last_hover_;
  std::optional<Look> looked_;  // the look that found hover_
  std::optional<BrushRing> sent_ring_;
};

}  // namespace burnish
