#pragma once

#include <cstdint>
#include <vector>

#include "client/scene/renderer.h"

namespace burnish {

/// A renderer without pictures: it remembers the last draw() and returns black pictures. It picks
/// by trying all triangles.
class NullRenderer : public Renderer {
 public:
  Status upload_mesh(const ViewMesh& mesh) override;
  Status upload_displacements(std::span<const Vec3f> displacements,
                              std::span<const IndexRange> changed) override;
  Status upload_cell_values(std::span<const float> values) override;
  Status upload_cell_tint(std::span<const float> weights, IndexRange changed) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) override;
  Result<Image> read_pixels() override;
  Result<std::optional<uint32_t>> pick(const Camera& camera, const ImageSize& size,
                                       const Eigen::Vector2i& pixel, bool original) override;

  uint64_t triangle_count() const { return mesh_.triangles.size(); }
  uint64_t draw_count() const { return draw_count_; }
  const Camera& camera() const { return camera_; }   ///< of the last draw()
  const DrawStyle& style() const { return style_; }  ///< of the last draw()
  std::span<const Vec3f> displacements() const { return displacements_; }
  std::span<const float> cell_values() const { return cell_values_; }
  std::span<const float> cell_tint() const { return cell_tint_; }

 private:
  ViewMesh mesh_;
  std::vector<Vec3f> displacements_;
  std::vector<float> cell_values_;
  std::vector<float> cell_tint_;
  uint64_t draw_count_ = 0;
  Camera camera_;
  DrawStyle style_;
  ImageSize size_;
};

}  // namespace burnish
