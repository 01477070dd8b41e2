#pragma once

#include <gtest/gtest.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/scene/page_surface.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {

inline constexpr ImageSize kStageSize{400, 300};

/// A context, a renderer of pages and a camera that looks at one mesh cut into pages, page i in
/// slot i.
class PageStage : public testing::Test {
 protected:
  static constexpr int kDepth = 5;

  void SetUp() override {
    auto context = EglContext::create();
    ASSERT_TRUE(context.is_ok()) << context.status().message();
    context_ = std::move(context).value();
    auto renderer = GlPageRenderer::create();
    ASSERT_TRUE(renderer.is_ok()) << renderer.status().message();
    renderer_ = std::move(renderer).value();
    surface_ = std::make_unique<PageSurface>(*renderer_);
  }

  void show(SplitMesh split) {
    split_ = std::move(split);
    space_ = make_page_space(split_.grid, kDepth);
    camera_.target = space_.centre;
    camera_.distance = 4.5 * space_.unit;
    camera_.scene_radius = 2 * space_.unit;
    surface_->open(space_);
    ASSERT_TRUE(surface_->reserve(static_cast<uint32_t>(split_.pages.size())).is_ok());
    meshes_.clear();
    for (const Page& page : split_.pages) meshes_.push_back(make_page_mesh(page, split_.grid));
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) put(slot, meshes_[slot]);
  }

  void put(uint32_t slot, const PageMesh& mesh) { ASSERT_TRUE(surface_->put(slot, mesh).is_ok()); }

  void move(uint32_t slot, std::vector<Vec3f> displacements) {
    surface_->move(slot, std::move(displacements));
  }

  PatchRange all_of(uint32_t slot) const {
    return {slot, 0, static_cast<uint32_t>(meshes_[slot].triangles.size())};
  }

  std::vector<PatchRange> all() const {
    std::vector<PatchRange> patches;
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) patches.push_back(all_of(slot));
    return patches;
  }

  Image draw(const DrawStyle& style, const std::vector<PatchRange>& patches) {
    const Status drawn = surface_->draw(camera_, kStageSize, style, patches);
    EXPECT_TRUE(drawn.is_ok()) << drawn.message();
    return std::move(renderer_->read_pixels()).value();
  }
  Image draw(const DrawStyle& style = {}) { return draw(style, all()); }

  SplitMesh split_;
  PageSpace space_;
  std::vector<PageMesh> meshes_;
  Camera camera_;
  std::unique_ptr<EglContext> context_;  // outlives the renderer
  std::unique_ptr<GlPageRenderer> renderer_;
  std::unique_ptr<PageSurface> surface_;
};

inline bool same_pixel(const Image& a, const Image& b, int x, int y) {
  return std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y));
}

/// Calls visit(x, y) for every pixel.
template <typename Visit>
void for_each_pixel(const Visit& visit) {
  for (int y = 0; y < kStageSize.height; ++y)
    for (int x = 0; x < kStageSize.width; ++x) visit(x, y);
}

inline int count_different(const Image& a, const Image& b) {
  int count = 0;
  for_each_pixel([&](int x, int y) { count += !same_pixel(a, b, x, y); });
  return count;
}

/// Returns the mean absolute difference of luminance, of 255.
inline double mean_luminance_difference(const Image& a, const Image& b) {
  const auto luminance = [](const uint8_t* rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  };
  double sum = 0;
  for_each_pixel(
      [&](int x, int y) { sum += std::abs(luminance(a.pixel(x, y)) - luminance(b.pixel(x, y))); });
  return sum / (kStageSize.width * kStageSize.height);
}

}  // namespace burnish
