#pragma once

#include "client/scene/draw_style.h"
#include "client/scene/image.h"
#include "client/scene/up_axis.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

struct PictureOptions {
  ImageSize size{1280, 960};
  double azimuth_degrees = 25;  ///< see Camera
  double elevation_degrees = 20;
  double zoom = 1;
  UpAxis up = UpAxis::kY;
  bool orthographic = false;
  DrawStyle style;
};

/// Draws one picture of the whole mesh, without a window, with LoneRenderer.
/// Needs: a valid mesh. Fails: invalid_argument (size), resource_exhausted.
Result<Image> draw_picture(const TriangleMesh& mesh, const PictureOptions& options);

}  // namespace burnish
