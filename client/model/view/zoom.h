#pragma once

#include <optional>

#include <Eigen/Geometry>

#include "client/scene/camera.h"

namespace burnish {

/// The point around which the wheel zooms.
struct ZoomPlace {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  std::optional<Vec3d> surface;  ///< what lies under the pixel, file units
};

/// Moves towards the surface at the pixel by wheel steps, away from it by negative ones. The eye
/// never passes a surface that is there. Beside the surface it stays before the scan's box, and the
/// box's middle stays in the picture. Away, the box's diagonal keeps a tenth of the picture's
/// height.
Camera zoomed_by_wheel(const Camera& camera, const ImageSize& size, const ZoomPlace& place,
                       double steps, const Eigen::AlignedBox3d& box);

}  // namespace burnish
