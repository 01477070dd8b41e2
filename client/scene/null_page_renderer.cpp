#include "client/scene/null_page_renderer.h"

#include "common/base/check.h"

namespace burnish {

void NullPageRenderer::open(const PageSpace&) {
  slots_.assign(slots_.size(), {});
}

Status NullPageRenderer::reserve(uint32_t slots) {
  RETURN_IF_ERROR(check_page_slots(slots));
  if (slots > slots_.size()) slots_.resize(slots);
  return Status::ok();
}

Status NullPageRenderer::upload_page(uint32_t slot, const PageMesh& mesh) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  slots_[slot] = {mesh, {}, {}, {}, {}, mesh.colours};
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
  return Status::ok();
}

Status NullPageRenderer::mark_page(uint32_t slot, std::span<const VertexMark> marks) {
  filled(slot, marks.size()).marks = {marks.begin(), marks.end()};
  return Status::ok();
}

Status NullPageRenderer::colour_page(uint32_t slot, std::span<const Rgba8> colours,
                                     std::span<const TexelChange> texels) {
  filled(slot, texels.size()).texels = {texels.begin(), texels.end()};
  filled(slot, colours.size()).colours = {colours.begin(), colours.end()};
  return Status::ok();
}

Status NullPageRenderer::texture_page(uint32_t slot, std::shared_ptr<const PageTexture> texture) {
  BURNISH_CHECK(slot < slots_.size(), "slots are reserved");
  slots_[slot].texture = std::move(texture);
  return Status::ok();
}

Status NullPageRenderer::draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
                              std::span<const PatchRange> patches) {
  RETURN_IF_ERROR(check_image_size(size));
  camera_ = camera;
  size_ = size;
  style_ = style;
  patches_ = {patches.begin(), patches.end()};
  has_drawn_ = true;
  return Status::ok();
}

Result<Image> NullPageRenderer::read_pixels() {
  if (!has_drawn_) return failed_precondition("nothing has been drawn yet");
  return Image{size_, std::vector<uint8_t>(3 * size_t(size_.width) * size_.height)};
}

}  // namespace burnish
