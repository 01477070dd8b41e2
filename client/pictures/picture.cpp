#include "client/pictures/picture.h"

#include <vector>

#include "client/pictures/lone_renderer.h"
#include "client/scene/likely_up.h"

namespace burnish {

Camera picture_camera(const PictureOptions& options, const Eigen::AlignedBox3d& box) {
  Camera camera;
  camera.azimuth_degrees = options.azimuth_degrees;
  camera.elevation_degrees = options.elevation_degrees;
  camera.zoom = options.zoom;
  camera.up = options.up.value_or(likely_up(box, {}, MeshFormat::kPly));
  camera.orthographic = options.orthographic;
  return frame_all(camera, box, options.size.aspect());
}

Result<Image> draw_picture(const RawPages& raw,
                           std::span<const std::shared_ptr<const PageTexture>> textures,
                           const PictureOptions& options, PageRenderer& renderer) {
  RETURN_IF_ERROR(check_image_size(options.size));
  ASSIGN_OR_RETURN(const auto patches, upload_pages(raw, renderer));
  for (uint32_t slot = 0; slot < textures.size(); ++slot)
    RETURN_IF_ERROR(renderer.texture_page(slot, textures[slot]));
  RETURN_IF_ERROR(
      renderer.draw(picture_camera(options, raw.box), options.size, options.style, patches));
  return renderer.read_pixels();
}

Result<Image> draw_picture(const TriangleMesh& mesh, const PictureOptions& options) {
  RETURN_IF_ERROR(check_image_size(options.size));
  const LoneRenderer renderer;
  return draw_picture(make_raw_pages(mesh), {}, options, *renderer);
}

}  // namespace burnish
