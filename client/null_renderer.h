#pragma once

#include <cstdint>

#include "client/renderer.h"

namespace burnish {

/// A renderer without pictures: it remembers what it was asked to draw, and every picture is black.
class NullRenderer : public Renderer {
 public:
  Status upload_mesh(const ViewMesh& mesh) override;
  Status draw(const Camera& camera, const ImageSize& size, const DrawStyle& style) override;
  Result<Image> read_pixels() override;

  uint64_t triangle_count() const { return triangle_count_; }
  uint64_t draw_count() const { return draw_count_; }
  const Camera& camera() const { return camera_; }  ///< of the last draw()

 private:
  uint64_t triangle_count_ = 0;
  uint64_t draw_count_ = 0;
  Camera camera_;
  ImageSize size_;
};

}  // namespace burnish
