#pragma once

#include <gtest/gtest.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/raster/raster_page_renderer.h"
#include "client/scene/page_surface.h"
#include "tests/client/raster/picture_rmse.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {

inline constexpr ImageSize kTwinSize{400, 300};

/// One mesh, cut into pages, that processors and OpenGL draw alike; page i is in slot i.
class TwinStage : public testing::Test {
 protected:
  static constexpr int kDepth = 5;

  /// The dialect that the twin of the processors speaks.
  virtual GlKind kind() const { return GlKind::kDesktop; }

  void SetUp() override {
    auto context = EglContext::create(kind());
    ASSERT_TRUE(context.is_ok()) << context.status().message();
    context_ = std::move(context).value();
    gl_ = std::move(GlPageRenderer::create()).value();
    gl_surface_ = std::make_unique<PageSurface>(*gl_);
  }

  void show(SplitMesh split) {
    split_ = std::move(split);
    space_ = make_page_space(split_.grid, kDepth);
    camera_.target = space_.centre;
    camera_.distance = 4.5 * space_.unit;
    camera_.scene_radius = 2 * space_.unit;
    meshes_.clear();
    for (const Page& page : split_.pages) meshes_.push_back(make_page_mesh(page, split_.grid));
    for (PageSurface* surface : {&surface_, gl_surface_.get()}) {
      surface->open(space_);
      ASSERT_TRUE(surface->reserve(static_cast<uint32_t>(meshes_.size())).is_ok());
      for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
        ASSERT_TRUE(surface->put(slot, meshes_[slot]).is_ok());
    }
  }

  /// Moves vertices by `field` of their places, in cells.
  template <typename Field>
  void move_by(const Field& field) {
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<Vec3f> moves;
      for (const Vec3f& at : meshes_[slot].positions) moves.push_back(field(at));
      surface_.move(slot, moves);
      gl_surface_->move(slot, moves);
    }
  }

  /// Marks vertices by `mark_of` their places.
  template <typename MarkOf>
  void mark_by(const MarkOf& mark_of) {
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      std::vector<VertexMark> marks;
      for (const Vec3f& at : meshes_[slot].positions) marks.push_back(mark_of(at));
      ASSERT_TRUE(raster_.mark_page(slot, marks).is_ok());
      ASSERT_TRUE(gl_->mark_page(slot, marks).is_ok());
    }
  }

  std::vector<PatchRange> all() const {
    std::vector<PatchRange> patches;
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
      patches.push_back({slot, 0, static_cast<uint32_t>(meshes_[slot].triangles.size())});
    return patches;
  }

  Image draw(const DrawStyle& style = {}) {
    EXPECT_TRUE(surface_.draw(camera_, kTwinSize, style, all()).is_ok());
    return std::move(raster_.read_pixels()).value();
  }
  Image draw_by_gl(const DrawStyle& style = {}) {
    EXPECT_TRUE(gl_surface_->draw(camera_, kTwinSize, style, all()).is_ok());
    return std::move(gl_->read_pixels()).value();
  }
  /// Returns picture_rmse() of both pictures.
  double rmse(const DrawStyle& style = {}) { return picture_rmse(draw(style), draw_by_gl(style)); }

  SplitMesh split_;
  PageSpace space_;
  std::vector<PageMesh> meshes_;
  Camera camera_;
  RasterPageRenderer raster_{2};
  PageSurface surface_{raster_};
  std::unique_ptr<EglContext> context_;  // outlives its renderer
  std::unique_ptr<GlPageRenderer> gl_;
  std::unique_ptr<PageSurface> gl_surface_;
};

}  // namespace burnish
