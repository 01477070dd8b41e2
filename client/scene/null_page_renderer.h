#pragma once

#include <cstdint>
#include <vector>

#include "client/scene/page_renderer.h"

namespace burnish {

/// A renderer of pages without pictures: it remembers what it was given and returns black pictures.
class NullPageRenderer : public PageRenderer {
 public:
  void open(const PageSpace& space) override;
  Status reserve(uint32_t slots) override;
  Status upload_page(uint32_t slot, const PageMesh& mesh) override;
  Status move_page(uint32_t slot, std::span<const Vec3f> displacements,
                   std::span<const Vec3f> normals, std::span<const float> ridges) override;
  Status mark_page(uint32_t slot, std::span<const VertexMark> marks) override;
  Status colour_page(uint32_t slot, std::span<const Rgba8> colours,
                     std::span<const TexelChange> texels) override;
  Status texture_page(uint32_t slot, std::shared_ptr<const PageTexture> texture) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
              std::span<const PatchRange> patches) override;
  Result<Image> read_pixels() override;

  uint64_t move_count() const { return move_count_; }               ///< of move_page()
  const Camera& camera() const { return camera_; }                  ///< of the last draw()
  const DrawStyle& style() const { return style_; }                 ///< of the last draw()
  std::span<const PatchRange> patches() const { return patches_; }  ///< of the last draw()

  // The content of a slot. Empty: the page is not moved, or not marked. Needs: a reserved slot.
  const PageMesh& page(uint32_t slot) const { return slots_[slot].mesh; }
  std::span<const Vec3f> displacements(uint32_t slot) const { return slots_[slot].displacements; }
  std::span<const Vec3f> normals(uint32_t slot) const { return slots_[slot].normals; }
  std::span<const float> ridges(uint32_t slot) const { return slots_[slot].ridges; }
  std::span<const VertexMark> marks(uint32_t slot) const { return slots_[slot].marks; }
  std::span<const Rgba8> colours(uint32_t slot) const { return slots_[slot].colours; }
  std::span<const TexelChange> texels(uint32_t slot) const { return slots_[slot].texels; }
  const PageTexture* texture(uint32_t slot) const { return slots_[slot].texture.get(); }

 private:
  struct Slot {
    PageMesh mesh;
    std::vector<Vec3f> displacements;
    std::vector<Vec3f> normals;  // displaced
    std::vector<float> ridges;   // displaced
    std::vector<VertexMark> marks;
    std::vector<Rgba8> colours;  // displaced
    std::vector<TexelChange> texels;
    std::shared_ptr<const PageTexture> texture;
  };
  Slot& filled(uint32_t slot, size_t vertices);

  std::vector<Slot> slots_;
  uint64_t move_count_ = 0;
  bool has_drawn_ = false;
  Camera camera_;
  DrawStyle style_;
  ImageSize size_;
  std::vector<PatchRange> patches_;
};

}  // namespace burnish
