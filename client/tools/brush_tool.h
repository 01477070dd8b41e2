#pragma once

#include <optional>
#include <vector>

#include "common/edit/brush.h"

namespace burnish {

/// What the keys held during a stroke make of the brush's β.
enum class BrushMode { kPaint, kInvert, kRestore };

/// The β that a stroke paints: the brush's own; its mirror image about 1, so that smoothing becomes
/// sharpening; or 1, which restores.
double painted_beta(double beta, BrushMode mode);

/// A brush and the stroke that it is drawing, if any. Points are of the original surface, in file
/// units.
class BrushTool {
 public:
  Brush brush{.radius = 1, .strength = 0.6, .beta = 0};

  /// Multiplies the radius, which stays within these parts of the scan's diagonal.
  void scale_radius(double factor, double diagonal);
  void set_radius(double radius, double diagonal);

  bool is_drawing() const { return stroke_.has_value(); }
  const Stroke& stroke() const { return *stroke_; }  ///< Needs: is_drawing()

  void begin(BrushMode mode, const Vec3d& point);
  /// A stroke that goes on where a full one ended.
  void go_on(const Brush& stroke_brush, const Vec3d& point);

  /// Adds a point, if it is far enough from the last one to matter. False when the stroke has no
  /// room for it: end it and begin another.
  bool extend(const Vec3d& point);

  /// The points since the last call, for those who draw or preview the stroke as it grows.
  std::vector<Vec3d> take_new_points();

  /// Ends the stroke and gives it.
  Stroke end();
  void cancel() { stroke_.reset(); }

 private:
  std::optional<Stroke> stroke_;
  double length_ = 0;  // of the path, file units
  size_t taken_ = 0;
};

}  // namespace burnish
