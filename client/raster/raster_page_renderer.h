#pragma once

#include <memory>
#include <vector>

#include "client/raster/g_buffer.h"
#include "client/raster/raster_page.h"
#include "client/raster/shaded_scene.h"
#include "client/raster/visibility.h"
#include "client/raster/work_crew.h"
#include "client/scene/page_renderer.h"

namespace burnish {

/// Limit of the textures that a client keeps for this renderer.
inline constexpr uint64_t kTextureBytesMax = 256'000'000;

/// One sample a pixel is for pictures of a moving camera; four give smooth edges.
enum class RasterSampling { kOne, kFour };

/// Draws pages with processors alone, for machines without a graphics card. Made for scans, whose
/// triangles are smaller than a pixel. The same input gives the same bits for any number of
/// threads.
class RasterPageRenderer : public PageRenderer {
 public:
  /// `threads`: 0 takes one for each core.
  explicit RasterPageRenderer(int threads = 0);

  void open(const PageSpace& space) override;
  Status reserve(uint32_t slots) override;
  Status upload_page(uint32_t slot, const PageMesh& mesh) override;
  Status move_page(uint32_t slot, std::span<const Vec3f> displacements,
                   std::span<const Vec3f> normals, std::span<const float> ridges) override;
  Status mark_page(uint32_t slot, std::span<const VertexMark> marks) override;
  Status colour_page(uint32_t slot, std::span<const Rgba8> colours,
                     std::span<const TexelChange> texels) override;
  uint64_t texture_bytes_max() const override { return kTextureBytesMax; }
  Status texture_page(uint32_t slot, std::shared_ptr<const PageTexture> texture) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style,
              std::span<const PatchRange> patches) override;
  Result<Image> read_pixels() override;

  /// Chooses the samples a pixel from the next draw() on. Four at first.
  void set_sampling(RasterSampling sampling) { sampling_ = sampling; }

  /// Returns the last drawn picture without a copy; empty before the first draw().
  const Image& picture() const { return image_; }
  /// Returns how long the last draw() takes where nothing else runs on the processors.
  double draw_ms() const { return draw_ms_; }

 private:
  RasterPage& filled(uint32_t slot, size_t vertices);
  void check_patches(std::span<const PatchRange> patches) const;
  void draw_pages(const PageProjection& projection, const DrawStyle& style,
                  std::span<const PatchRange> patches);
  void shade(const ShadedScene& scene);
  void shade_with_surroundings(const ShadedScene& scene, const Lighting& lighting);

  WorkCrew crew_;
  PageSpace space_;
  std::vector<RasterPage> pages_;  // by slot
  RasterSampling sampling_ = RasterSampling::kFour;
  Visibility visibility_;
  GBuffer g_buffer_;
  std::vector<uint8_t> occlusions_;
  Image image_;
  double draw_ms_ = 0;
};

}  // namespace burnish
