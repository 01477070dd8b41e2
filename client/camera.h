#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "common/base/types.h"

namespace burnish {

/// A turntable around a point: the y axis is up, azimuth 0 and elevation 0 look along -z.
struct Camera {
  Vec3d target = Vec3d::Zero();       ///< file units; the middle of the picture
  double distance = 1;                ///< from the eye to the target, file units
  double azimuth_degrees = 0;         ///< turns the eye from +z towards +x
  double elevation_degrees = 0;       ///< lifts the eye towards +y
  double field_of_view_degrees = 30;  ///< of the picture's height at zoom 1
  double zoom = 1;                    ///< magnifies the picture, keeps the perspective
  double scene_radius = 1;            ///< around the target, file units; sets the depth range
};

/// The camera's axes in the world as rows: right, up, and back (from the target to the eye).
Eigen::Matrix3d camera_axes(const Camera& camera);

/// World to camera space: x right, y up, the eye at the origin looking along -z.
Eigen::Matrix4d view_matrix(const Camera& camera);

/// Camera space to OpenGL clip space. `aspect` is width over height.
Eigen::Matrix4d projection_matrix(const Camera& camera, double aspect);

/// The same view moved so that the whole box just fits, with a small margin, at zoom 1.
Camera frame_all(Camera camera, const Eigen::AlignedBox3d& box, double aspect);

}  // namespace burnish
