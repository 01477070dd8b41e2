#pragma once

#include <optional>
#include <vector>

#include "client/model/document.h"
#include "client/scene/camera.h"
#include "client/scene/renderer.h"

namespace burnish {

enum class PointerButton { kLeft, kMiddle, kRight };

struct Modifiers {
  bool shift = false;
  bool control = false;
  bool alt = false;
};

/// How the surface is shown.
struct ViewOptions {
  bool flat = false;
  bool wireframe = false;
  bool split = false;
  double split_at = 0.5;          ///< part of the width
  double displacement_range = 1;  ///< cells
};

/// The picture of a document: where it is seen from, and what the pointer does to it. Events are
/// kept until update(), which asks the renderer what lies under the pointer. Pixels are the
/// picture's own, from its upper left corner. Needs no window.
class Viewport {
 public:
  Camera camera;
  ViewOptions options;
  bool navigate_mode = false;  ///< the left button turns
  bool hold_original = false;  ///< before/after
  std::vector<Camera> bookmarks;

  void set_size(const ImageSize& size) { size_ = size; }
  const ImageSize& size() const { return size_; }

  void press(PointerButton button, const Modifiers& modifiers, const Eigen::Vector2d& pixel);
  void move(const Eigen::Vector2d& pixel);
  void release(PointerButton button);
  void wheel(const Eigen::Vector2d& pixel, double steps);
  void leave();  ///< the pointer is elsewhere

  /// As for a document just opened: nothing of the one before is kept but how surfaces are shown.
  void begin(const Document& document);
  void frame_all(const Document& document);
  void focus();  ///< on the point under the pointer
  void begin_radius(const Document& document);
  void begin_strength(const Document& document);
  /// Ends what the pointer is doing without a trace. False when it was doing nothing.
  bool cancel(Document& document);

  /// Handles what the pointer did. Fails: as the renderer does.
  Status update(Renderer& renderer, Document& document);

  /// The surface under the pointer as it was at the last update().
  const std::optional<SurfaceHit>& hover() const { return hover_; }
  const std::optional<Eigen::Vector2d>& pointer() const { return pointer_; }
  bool is_busy() const { return gesture_ != Gesture::kIdle; }

  DrawStyle style(const Document& document) const;

 private:
  enum class Gesture { kIdle, kStroke, kTurn, kPan, kRadius, kStrength };
  struct Event {
    enum class Kind { kPress, kMove, kRelease } kind;
    Eigen::Vector2d pixel;
    BrushMode mode = BrushMode::kPaint;
  };

  /// What decides what a look finds.
  struct Look {
    Eigen::Vector2d pixel;
    Camera camera;
    ImageSize size;
    uint64_t frames = 0;  // that moved the surface so far
    bool original = false;

    bool operator==(const Look&) const = default;
  };

  bool shows_original(const Eigen::Vector2d& pixel) const;
  Status look_at(const Eigen::Vector2d& pixel, Renderer& renderer, const Document& document);
  Result<std::optional<SurfaceHit>> hit_at(Renderer& renderer, const Document& document,
                                           const Eigen::Vector2d& pixel) const;
  Status paint(const Event& event, Renderer& renderer, Document& document);
  void drag_camera(const Eigen::Vector2d& by);
  void drag_value(Document& document);
  void send_ring(Document& document);

  ImageSize size_{1, 1};
  Gesture gesture_ = Gesture::kIdle;
  PointerButton held_ = PointerButton::kLeft;
  std::optional<Eigen::Vector2d> pointer_;
  Eigen::Vector2d drag_from_ = Eigen::Vector2d::Zero();
  double value_from_ = 0;  // of the radius or strength when its drag began
  bool value_changes_ = false;
  std::vector<Event> events_;  // of the brush
  std::optional<SurfaceHit> hover_;
  std::optional<Look> looked_;  // that found hover_
  std::optional<BrushRing> sent_ring_;
};

}  // namespace burnish
