#pragma once

#include <vector>

#include "client/scene/page_renderer.h"

namespace burnish {

/// A renderer of pages without pictures: it remembers the last draw() and returns black pictures.
/// It picks by trying all triangles.
class NullPageRenderer : public PageRenderer {
 public:
  void open(const PageSpace& space) override;
  Status reserve(uint32_t slots) override;
  Status upload_page(uint32_t slot, const PageMesh& mesh) override;
  Status move_page(uint32_t slot, std::span<const Vec3f> displacements,
                   std::span<const Vec3f> normals) override;
  Status mark_page(uint32_t slot, std::span<const VertexMark> marks) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
              std::span<const PatchRange> patches) override;
  Result<Image> read_pixels() override;
  Result<std::optional<PagePick>> pick(const Camera& camera, const ImageSize& size,
                                       const Eigen::Vector2i& pixel, bool original,
                                       std::span<const PatchRange> patches) override;

  const Camera& camera() const { return camera_; }                  ///< of the last draw()
  const DrawStyle& style() const { return style_; }                 ///< of the last draw()
  std::span<const PatchRange> patches() const { return patches_; }  ///< of the last draw()

 private:
  struct Slot {
    PageMesh mesh;
    std::vector<Vec3f> displacements;
  };
  Slot& filled(uint32_t slot, size_t vertices);

  PageSpace space_;
  std::vector<Slot> slots_;
  bool has_drawn_ = false;
  Camera camera_;
  DrawStyle style_;
  ImageSize size_;
  std::vector<PatchRange> patches_;
};

}  // namespace burnish
