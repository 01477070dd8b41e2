#pragma once

#include <memory>
#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "client/scene/camera.h"
#include "client/scene/draw_style.h"
#include "client/scene/image.h"
#include "client/scene/page_renderer.h"
#include "client/scene/page_texture.h"
#include "client/scene/raw_pages.h"
#include "client/scene/up_axis.h"
#include "common/base/status.h"
#include "common/mesh/triangle_mesh.h"

namespace burnish {

struct PictureOptions {
  ImageSize size{1280, 960};
  double azimuth_degrees = 25;  ///< see Camera
  double elevation_degrees = 20;
  double zoom = 1;
  std::optional<UpAxis> up;  ///< none: likely_up() of numbers without a unit
  bool orthographic = false;
  DrawStyle style;
};

/// Returns the camera of a picture of all that is in a box, file units.
Camera picture_camera(const PictureOptions& options, const Eigen::AlignedBox3d& box);

/// Draws one picture of the whole mesh, without a window, with LoneRenderer.
/// Needs: a valid mesh. Fails: invalid_argument (size), resource_exhausted.
Result<Image> draw_picture(const TriangleMesh& mesh, const PictureOptions& options);

/// Draws one picture of raw pages with their textures. `textures`: one for each page; null: the
/// page shows its vertices' colours. Needs: the textures are as texture_page() needs them.
/// Fails: likewise.
Result<Image> draw_picture(const RawPages& raw,
                           std::span<const std::shared_ptr<const PageTexture>> textures,
                           const PictureOptions& options, PageRenderer& renderer);

}  // namespace burnish
