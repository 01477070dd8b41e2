#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "client/scene/image.h"
#include "client/scene/up_axis.h"
#include "common/base/types.h"

namespace burnish {

/// A turntable around a point. While y is up, azimuth 0 and elevation 0 look along -z; another axis
/// turns as to_turntable() says.
struct Camera {
  Vec3d target = Vec3d::Zero();       ///< file units; the middle of the picture
  double distance = 1;                ///< from the eye to the target, file units
  double azimuth_degrees = 0;         ///< turns the eye from +z towards +x
  double elevation_degrees = 0;       ///< lifts the eye towards +y
  double field_of_view_degrees = 30;  ///< of the picture's height at zoom 1
  double zoom = 1;                    ///< magnifies the picture, keeps the perspective
  double scene_radius = 1;            ///< around the target, file units; sets the depth range
  UpAxis up = UpAxis::kY;
  bool orthographic = false;  ///< no perspective: sizes are those at the target's distance

  bool operator==(const Camera&) const = default;
};

/// Returns the camera's axes in the world as rows: right, up, and back (from the target to the
/// eye).
Eigen::Matrix3d camera_axes(const Camera& camera);

/// Returns the map from world to camera space: x right, y up, the eye at the origin looking along
/// -z.
Eigen::Matrix4d view_matrix(const Camera& camera);

/// Returns the map from camera space to OpenGL clip space. `aspect` is width over height.
Eigen::Matrix4d projection_matrix(const Camera& camera, double aspect);

/// Moves the camera so that the whole box just fits, with a small margin, at zoom 1.
Camera frame_all(Camera camera, const Eigen::AlignedBox3d& box, double aspect);

/// A half line in file units.
struct Ray {
  Vec3d origin;
  Vec3d direction;  ///< unit length
};

/// Returns the ray from the eye through a point of the picture, in pixels from the upper left
/// corner. A pixel's middle lies at 0.5. An orthographic ray begins in front of the scene.
Ray pixel_ray(const Camera& camera, const ImageSize& size, const Eigen::Vector2d& pixel);

/// Returns the place of a world point in the picture, in the pixels of pixel_ray().
/// Needs: a point in front of the eye.
Eigen::Vector2d pixel_of(const Camera& camera, const ImageSize& size, const Vec3d& point);

/// Returns the size of a pixel at the target's distance, in file units.
double pixel_length(const Camera& camera, const ImageSize& size);

/// Turns around the target; the elevation stops at the poles.
Camera turned(Camera camera, double azimuth_degrees, double elevation_degrees);

/// Moves the picture by `pixels`: points as far away as the target follow the cursor.
Camera panned(Camera camera, const ImageSize& size, const Eigen::Vector2d& pixels);

/// Moves the eye nearer (factor < 1) or farther. A point under the cursor, as far away as the
/// target, stays there.
Camera zoomed_at(Camera camera, const ImageSize& size, const Eigen::Vector2d& pixel, double factor);

/// Moves the target along the view to the depth of a point; the picture stays. A point behind the
/// eye of a perspective changes nothing.
Camera with_target_as_deep_as(Camera camera, const Vec3d& point);

/// Returns what the scan's diagonal measures at the target's distance, as a part of the picture's
/// height.
double covered_part(const Camera& camera, double diagonal);

/// Returns the camera with a depth range that holds the box, wherever the target is.
Camera with_depth_of(Camera camera, const Eigen::AlignedBox3d& box);

}  // namespace burnish
