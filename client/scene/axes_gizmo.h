#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "client/scene/camera.h"
#include "client/scene/image.h"
#include "client/scene/standard_view.h"
#include "client/scene/up_axis.h"

namespace burnish {

/// An end of one of the scan's axes, over the picture.
struct AxisEnd {
  UpAxis axis;            ///< the way to it from the middle
  StandardView view;      ///< the one that has it before the middle
  Eigen::Vector2d place;  ///< pixels of the picture
  double depth;           ///< -1 to 1: towards the eye
};

/// The scan's axes as the camera sees them, in the picture's upper left corner. All lengths are
/// pixels of the picture.
struct AxesGizmo {
  Eigen::Vector2d middle;
  double radius;                      ///< around all of it
  double end_radius;                  ///< of an end
  std::array<AxisEnd, kUpAxes> ends;  ///< the farthest first
};

/// Returns nothing for a picture without room. `pixel_ratio`: as of scale_bar().
std::optional<AxesGizmo> axes_gizmo(const Camera& camera, const ImageSize& size,
                                    double pixel_ratio);

/// Returns the nearest end at a pixel of the picture; null: there is none.
const AxisEnd* end_at(const AxesGizmo& gizmo, const Eigen::Vector2d& pixel);

/// Returns whether the gizmo takes what is done at a pixel of the picture.
bool covers(const AxesGizmo& gizmo, const Eigen::Vector2d& pixel);

}  // namespace burnish
