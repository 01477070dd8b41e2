#pragma once

#include <optional>
#include <vector>

#include "common/edit/brush.h"

namespace burnish {

/// The effect of keys held during a stroke on what the brush paints.
enum class BrushMode { kPaint, kInvert, kRestore };

/// Returns the value that a stroke paints: the brush's own; its mirror image, which turns smoothing
/// into sharpening, and denoising into keeping; or that which restores.
double painted_value(const Brush& brush, BrushMode mode);

/// A brush and its current stroke, if any. Points lie on the original surface, in file units.
class BrushTool {
 public:
  Brush brush{.radius = 1, .strength = 0.6, .beta = 0, .connected = true};

  /// Multiplies the radius; the result stays within fixed parts of the scan's diagonal.
  void scale_radius(double factor, double diagonal);
  void set_radius(double radius, double diagonal);

  bool is_drawing() const { return stroke_.has_value(); }
  const Stroke& stroke() const { return *stroke_; }  ///< Needs: is_drawing()

  /// `pressure`: of a pen, 0 to 1.
  void begin(BrushMode mode, const Vec3d& point, double pressure = 1);
  /// Begins a stroke where the last one ended, with the same brush.
  void go_on(const Vec3d& point, double pressure = 1);

  /// Adds a point if it is far enough from the last one. Returns nothing, or where another stroke
  /// must go on: end this one, go_on() there, and extend again. A full stroke goes on at `point`.
  /// Another pressure goes on at the next dab, so that both strokes have the dabs of one.
  std::optional<Vec3d> extend(const Vec3d& point, double pressure = 1);

  /// Returns the points since the last call, to draw or preview the growing stroke.
  std::vector<Vec3d> take_new_points();

  /// Ends the stroke and returns it.
  Stroke end();
  void cancel() { stroke_.reset(); }

 private:
  double spacing() const { return kDabSpacing * stroke_->brush.radius; }
  std::optional<Vec3d> next_dab(const Vec3d& point) const;

  std::optional<Stroke> stroke_;
  Brush gesture_brush_;  // of its first stroke, before the pen's pressure
  double pressure_ = 1;  // of the stroke
  double length_ = 0;    // of the path, file units
  size_t taken_ = 0;
};

}  // namespace burnish
