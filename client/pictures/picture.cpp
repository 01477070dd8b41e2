#include "client/pictures/picture.h"

#include "client/pictures/lone_renderer.h"
#include "client/scene/raw_pages.h"

namespace burnish {

Result<Image> draw_picture(const TriangleMesh& mesh, const PictureOptions& options) {
  RETURN_IF_ERROR(check_image_size(options.size));
  const LoneRenderer renderer;
  const RawPages raw = make_raw_pages(mesh);
  ASSIGN_OR_RETURN(const auto patches, upload_pages(raw, *renderer));
  Camera camera;
  camera.azimuth_degrees = options.azimuth_degrees;
  camera.elevation_degrees = options.elevation_degrees;
  camera.zoom = options.zoom;
  camera.up = options.up;
  camera.orthographic = options.orthographic;
  camera = frame_all(camera, raw.box, options.size.aspect());
  RETURN_IF_ERROR(renderer->draw(camera, options.size, options.style, patches));
  return renderer->read_pixels();
}

}  // namespace burnish
