#include "client/scene/null_renderer.h"

#include <algorithm>

#include "client/scene/displaced_surface.h"

namespace burnish {

Status NullRenderer::upload_mesh(const ViewMesh& mesh) {
  mesh_ = mesh;
  displacements_.assign(mesh.corner_count, Vec3f::Zero());
  cell_values_.assign(mesh.cell_corners.size(), 0.0f);
  return Status::ok();
}

Status NullRenderer::upload_displacements(std::span<const Vec3f> displacements,
                                          std::span<const IndexRange> changed) {
  for (const IndexRange& range : changed)
    std::copy_n(displacements.begin() + range.first, range.count,
                displacements_.begin() + range.first);
  return Status::ok();
}

Status NullRenderer::upload_cell_values(std::span<const float> values) {
  cell_values_.assign(values.begin(), values.end());
  return Status::ok();
}

Status NullRenderer::upload_cell_tint(std::span<const float> weights, IndexRange) {
  cell_tint_.assign(weights.begin(), weights.end());
  return Status::ok();
}

Status NullRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) {
  RETURN_IF_ERROR(check_image_size(size));
  camera_ = camera;
  size_ = size;
  style_ = style;
  ++draw_count_;
  return Status::ok();
}

Result<Image> NullRenderer::read_pixels() {
  if (draw_count_ == 0) return failed_precondition("nothing has been drawn yet");
  return Image{size_, std::vector<uint8_t>(3 * size_t(size_.width) * size_.height)};
}

Result<std::optional<uint32_t>> NullRenderer::pick(const Camera& camera, const ImageSize& size,
                                                   const Eigen::Vector2i& pixel, bool original) {
  const Ray ray = pixel_ray(camera, size, pixel.cast<double>() + Eigen::Vector2d(0.5, 0.5));
  const std::span<const Vec3f> nowhere;
  const auto hit = nearest_hit({mesh_, original ? nowhere : displacements_}, ray);
  return hit ? std::optional<uint32_t>(hit->triangle) : std::nullopt;
}

}  // namespace burnish
