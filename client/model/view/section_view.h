#pragma once

#include <string>
#include <vector>

#include "client/report/length_ticks.h"
#include "client/scene/camera.h"
#include "client/tools/ruler.h"
#include "common/measure/plane.h"

namespace burnish {

/// Returns the plane through both ends of a ruler and the eye's direction. Needs: two ends.
Plane section_plane(const Ruler& ruler, const Camera& camera);

/// Turns the points of a section so that the ruler lies level.
class SectionView {
 public:
  /// Needs: two ends; a plane through the first.
  SectionView(const Plane& plane, const Ruler& ruler);

  /// Returns the way along the ruler from its first end, and the height over it, in lengths of the
  /// ruler. `point`: in the plane's axes.
  Eigen::Vector2d place(const Eigen::Vector2d& point) const;

  /// Returns the marks of a way or a height, where place() counts from and to. All three are in
  /// lengths of the ruler, and so is LengthTick::at.
  std::vector<LengthTick> ticks(double low, double high, double apart,
                                const std::string& unit) const;

 private:
  Eigen::Vector2d turn_;
  double length_;
};

}  // namespace burnish
