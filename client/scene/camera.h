#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "client/scene/image.h"
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

  bool operator==(const Camera&) const = default;
};

/// The camera's axes in the world as rows: right, up, and back (from the target to the eye).
Eigen::Matrix3d camera_axes(const Camera& camera);

/// World to camera space: x right, y up, the eye at the origin looking along -z.
Eigen::Matrix4d view_matrix(const Camera& camera);

/// Camera space to OpenGL clip space. `aspect` is width over height.
Eigen::Matrix4d projection_matrix(const Camera& camera, double aspect);

/// The same view moved so that the whole box just fits, with a small margin, at zoom 1.
Camera frame_all(Camera camera, const Eigen::AlignedBox3d& box, double aspect);

/// A half line in file units.
struct Ray {
  Vec3d origin;
  Vec3d direction;  ///< unit length
};

/// The ray from the eye through a point of the picture, in pixels from its upper left corner: a
/// pixel's middle lies at one half.
Ray pixel_ray(const Camera& camera, const ImageSize& size, const Eigen::Vector2d& pixel);

/// Where a point of the world lies in the picture, as pixel_ray() counts.
/// Needs: a point before the eye.
Eigen::Vector2d pixel_of(const Camera& camera, const ImageSize& size, const Vec3d& point);

/// File units across one pixel at the target's distance.
double pixel_length(const Camera& camera, const ImageSize& size);

/// Turns around the target; the elevation stops at the poles.
Camera turned(Camera camera, double azimuth_degrees, double elevation_degrees);

/// Moves the picture by so many pixels: what is as far as the target follows the cursor.
Camera panned(Camera camera, const ImageSize& size, const Eigen::Vector2d& pixels);

/// Brings the eye nearer (factor < 1) or farther; what is as far as the target and under the cursor
/// stays there.
Camera zoomed_at(Camera camera, const ImageSize& size, const Eigen::Vector2d& pixel, double factor);

/// The same camera with a depth range that holds the box, wherever the target is.
Camera with_depth_of(Camera camera, const Eigen::AlignedBox3d& box);

}  // namespace burnish
