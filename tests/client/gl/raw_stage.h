#pragma once

#include <gtest/gtest.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/scene/raw_pages.h"

namespace burnish {

inline constexpr ImageSize kRawSize{400, 300};

/// A context and a renderer that draws one mesh without a session.
class RawStage : public testing::Test {
 protected:
  void SetUp() override {
    auto context = EglContext::create();
    ASSERT_TRUE(context.is_ok()) << context.status().message();
    context_ = std::move(context).value();
    renderer_ = std::move(GlPageRenderer::create()).value();
  }

  void show(const TriangleMesh& mesh) {
    const RawPages raw = make_raw_pages(mesh);
    auto patches = upload_pages(raw, *renderer_);
    ASSERT_TRUE(patches.is_ok()) << patches.status().message();
    patches_ = std::move(patches).value();
    camera_ = frame_all(camera_, raw.box, kRawSize.aspect());
  }

  Image draw_styled(const DrawStyle& style) {
    const Status drawn = renderer_->draw(camera_, kRawSize, style, patches_);
    EXPECT_TRUE(drawn.is_ok()) << drawn.message();
    return std::move(renderer_->read_pixels()).value();
  }
  Image draw(const Lighting& lighting = {}) {
    DrawStyle style;
    style.lighting = lighting;
    return draw_styled(style);
  }
  Image draw_nothing() {
    patches_.clear();
    return draw();
  }

  Camera camera_;
  std::unique_ptr<EglContext> context_;  // outlives the renderer
  std::unique_ptr<GlPageRenderer> renderer_;
  std::vector<PatchRange> patches_;
};

inline double luminance_at(const Image& image, int x, int y) {
  const uint8_t* rgb = image.pixel(x, y);
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

}  // namespace burnish
