#include "client/null_renderer.h"

namespace burnish {

Status NullRenderer::upload_mesh(const ViewMesh& mesh) {
  triangle_count_ = mesh.triangles.size();
  return Status::ok();
}

Status NullRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle&) {
  RETURN_IF_ERROR(check_image_size(size));
  camera_ = camera;
  size_ = size;
  ++draw_count_;
  return Status::ok();
}

Result<Image> NullRenderer::read_pixels() {
  if (draw_count_ == 0) return failed_precondition("nothing was drawn yet");
  return Image{size_, std::vector<uint8_t>(3 * size_t(size_.width) * size_.height)};
}

}  // namespace burnish
