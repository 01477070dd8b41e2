#include "client/scene/null_page_renderer.h"

#include <limits>

#include "client/scene/displaced_page.h"
#include "client/scene/ray_box.h"
#include "common/base/check.h"

namespace burnish {

void NullPageRenderer::open(const PageSpace& space) {
  space_ = space;
  slots_.assign(slots_.size(), {});
}

Status NullPageRenderer::reserve(uint32_t slots) {
  RETURN_IF_ERROR(check_page_slots(slots));
  if (slots > slots_.size()) slots_.resize(slots);
  return Status::ok();
}

static Eigen::AlignedBox3d page_box(const DisplacedPage& page) {
  Eigen::AlignedBox3d box;
  for (size_t v = 0; v < page.mesh.positions.size(); ++v) box.extend(displaced_position(page, v));
  return box;
}

Status NullPageRenderer::upload_page(uint32_t slot, const PageMesh& mesh) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  const Eigen::AlignedBox3d box = page_box({mesh, space_, {}});
  slots_[slot] = {mesh, {}, {}, {}, {}, box, box};
  return Status::ok();
}

NullPageRenderer::Slot& NullPageRenderer::filled(uint32_t slot, size_t vertices) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  BURNISH_CHECK(slots_[slot].mesh.positions.size() == vertices, "one per vertex of the page");
  return slots_[slot];
}

Status NullPageRenderer::move_page(uint32_t slot, std::span<const Vec3f> displacements,
                                   std::span<const Vec3f> normals, std::span<const float> ridges) {
  ++move_count_;
  Slot& held = filled(slot, displacements.size());
  held.displacements = {displacements.begin(), displacements.end()};
  held.normals = {normals.begin(), normals.end()};
  held.ridges = {ridges.begin(), ridges.end()};
  held.displaced_box = page_box({held.mesh, space_, displacements});
  return Status::ok();
}

Status NullPageRenderer::mark_page(uint32_t slot, std::span<const VertexMark> marks) {
  filled(slot, marks.size()).marks = {marks.begin(), marks.end()};
  return Status::ok();
}

Status NullPageRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                              std::span<const PatchRange> patches) {
  RETURN_IF_ERROR(check_image_size(size));
  camera_ = camera;
  size_ = size;
  style_ = style;
  patches_ = {patches.begin(), patches.end()};
  ++draw_count_;
  return Status::ok();
}

Result<Image> NullPageRenderer::read_pixels() {
  if (draw_count_ == 0) return failed_precondition("nothing has been drawn yet");
  return Image{size_, std::vector<uint8_t>(3 * size_t(size_.width) * size_.height)};
}

Result<std::optional<PagePick>> NullPageRenderer::pick(const Camera& camera, const ImageSize& size,
                                                       const Eigen::Vector2i& pixel, bool original,
                                                       std::span<const PatchRange> patches) {
  const Ray ray = pixel_ray(camera, size, pixel.cast<double>() + Eigen::Vector2d(0.5, 0.5));
  std::optional<PagePick> picked;
  double nearest = std::numeric_limits<double>::infinity();
  for (const PatchRange& patch : patches) {
    const Slot& slot = slots_[patch.slot];
    const auto reached = distance_to_box(ray, original ? slot.original_box : slot.displaced_box);
    if (!reached || *reached > nearest) continue;
    const std::span<const Vec3f> nowhere;
    const DisplacedPage page{slot.mesh, space_, original ? nowhere : slot.displacements};
    const auto hit = nearest_hit(page, ray, patch.first, patch.count);
    if (!hit || hit->distance >= nearest) continue;
    nearest = hit->distance;
    picked = PagePick{patch.slot, hit->triangle};
  }
  return picked;
}

}  // namespace burnish
