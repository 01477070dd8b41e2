#include <cmath>

#include "client/pages/page_view.h"
#include "client/sheets/opened_texture.h"
#include "common/generate/generate.h"
#include "common/sheets/cut_charts.h"
#include "tests/client/raster/twin_stage.h"
#include "tests/common/sheets/made_texture.h"

namespace burnish {
namespace {

const DrawStyle kUnlit{.colouring = Colouring::kScan, .lighting = {.kind = LightKind::kUnlit}};

/// Returns a byte in linear light, or the other way round.
double in_linear(double byte) {
  return std::pow(byte / 255, 2.2);
}
double in_srgb(double light) {
  return 255 * std::pow(std::clamp(light, 0.0, 1.0), 1 / 2.2);
}

/// A scan whose sheets are baked from a pattern in space; its vertices are grey.
class TexturePicture : public TwinStage {
 protected:
  void SetUp() override {
    TwinStage::SetUp();
    TriangleMesh blob = generate_scan({.kind = "blob", .vertices = 3000}).value();
    blob.colours.assign(blob.vertices.size(), kGrey);
    show(split_into_pages(blob, 2500));
    camera_.azimuth_degrees = 25;
    camera_.elevation_degrees = 20;
    wave_ = 0.4 * space_.unit / split_.grid.step();
    const PageView view = make_page_view(camera_, kTwinSize, split_.grid);
    const double density = view.pixels_at_one / camera_.distance;  // a texel for each pixel
    for (const Page& page : split_.pages) textures_.push_back(texture_of(page, density));
  }

  std::shared_ptr<const PageTexture> texture_of(const Page& page, double density) const {
    const double per_step = density * split_.grid.step();
    const PageCharts charts = cut_charts(page, per_step);
    const auto per_step_float = static_cast<float>(per_step);
    Sheet sheet = baked_sheet(page, charts, per_step_float, pattern_on(page, wave_), 1);
    sheet.density = static_cast<float>(density);
    return std::make_shared<const PageTexture>(
        make_page_texture(page, charts, std::move(sheet), split_.grid));
  }

  void put_textures() {
    for (uint32_t slot = 0; slot < textures_.size(); ++slot) {
      ASSERT_TRUE(raster_.texture_page(slot, textures_[slot]).is_ok());
      const Status put = gl_->texture_page(slot, textures_[slot]);
      ASSERT_TRUE(put.is_ok()) << put.message();
    }
  }

  /// Returns the part of both pictures' pixels that are at most a level apart.
  double part_of_twins(const DrawStyle& style) {
    const Image one = draw(style), other = draw_by_gl(style);
    int alike = 0;
    for (size_t i = 0; i < one.rgb.size(); i += 3) {
      bool is_alike = true;
      for (size_t c = i; c < i + 3; ++c) is_alike &= std::abs(one.rgb[c] - other.rgb[c]) <= 1;
      alike += is_alike;
    }
    return 3.0 * alike / static_cast<double>(one.rgb.size());
  }

  void expect_twins() {
    put_textures();
    EXPECT_GT(part_of_twins(kUnlit), 0.99);
    EXPECT_LT(rmse(kUnlit), 0.003);
    EXPECT_LT(rmse({.colouring = Colouring::kScan}), 0.003);
    wave();
    EXPECT_LT(rmse(kUnlit), 0.003);
    strengthen();
    EXPECT_LT(rmse(kUnlit), 0.004);
    camera_.distance *= 2.5;
    EXPECT_LT(rmse(kUnlit), 0.003);
  }

  /// Gives both renderers texels of other gains.
  void strengthen() {
    for (uint32_t slot = 0; slot < textures_.size(); ++slot) {
      const std::vector<Vec3f>& positions = meshes_[slot].positions;
      std::vector<TexelChange> texels(positions.size());
      for (size_t v = 0; v < texels.size(); ++v)
        texels[v] = texel_change(kGrey, Vec3f(0, 0.1F, 0), 1.5F + 0.5F * positions[v].x());
      const std::vector<Rgba8> colours(texels.size(), kGrey);
      ASSERT_TRUE(raster_.colour_page(slot, colours, texels).is_ok());
      ASSERT_TRUE(gl_->colour_page(slot, colours, texels).is_ok());
    }
  }

  void wave() {
    move_by([](const Vec3f& at) {
      return Vec3f(0.6f * std::sin(8 * at.y()), 0.8f * std::cos(6 * at.x()), 0.5f * at.x());
    });
  }

  /// Returns the part of the surface's pixels that show the pattern, times `gain` and changed by
  /// `change` in linear light.
  double part_alike(const Image& image, double change = 0, double gain = 1) {
    int alike = 0, all = 0;
    for (int y = 2; y < kTwinSize.height; y += 3)
      for (int x = 2; x < kTwinSize.width; x += 3) {
        const auto hit = surface_.hit(pixel_ray(camera_, kTwinSize, {x + 0.5, y + 0.5}), false);
        if (!hit) continue;
        const Vec3d steps = (hit->point.original - split_.grid.origin) / split_.grid.step();
        const Texel pattern = pattern_at(steps - Vec3d::Constant(0.5), wave_);
        bool is_alike = true;
        for (int c = 0; c < 3; ++c)
          is_alike &=
              std::abs(in_srgb(gain * in_linear(pattern[c]) + change) - image.pixel(x, y)[c]) < 13;
        alike += is_alike;
        ++all;
      }
    EXPECT_GT(all, 300);
    return double(alike) / all;
  }

  static constexpr Rgba8 kGrey = {100, 100, 100, 255};
  double wave_ = 1;  // steps
  std::vector<std::shared_ptr<const PageTexture>> textures_;
};

TEST_F(TexturePicture, EveryPixelShowsItsTexel) {
  EXPECT_LT(part_alike(draw(kUnlit)), 0.1);
  put_textures();
  EXPECT_GT(part_alike(draw(kUnlit)), 0.98);
}

TEST_F(TexturePicture, TexelsMoveWithTheSurface) {
  put_textures();
  const Image still = draw(kUnlit);
  wave();
  const Image moved = draw(kUnlit);
  EXPECT_GT(picture_rmse(still, moved), 0.01);
  EXPECT_GT(part_alike(moved), 0.97);
}

TEST_F(TexturePicture, TexelsChangeAsTheColoursOfTheirVertices) {
  put_textures();
  wave();
  const Image before = draw(kUnlit);
  for (uint32_t slot = 0; slot < textures_.size(); ++slot) {
    const std::vector<Rgba8> lighter(meshes_[slot].positions.size(), Rgba8{140, 140, 140, 255});
    const std::vector<TexelChange> texels(lighter.size(), texel_change(kGrey, lighter[0]));
    ASSERT_TRUE(raster_.colour_page(slot, lighter, texels).is_ok());
  }
  const double change = in_linear(140) - in_linear(100);
  EXPECT_GT(part_alike(draw(kUnlit), change), 0.97);
  DrawStyle original = kUnlit;
  original.original = true;
  const Image still = draw(original);
  wave();
  EXPECT_NE(draw(kUnlit).rgb, before.rgb);
  EXPECT_EQ(draw(original).rgb, still.rgb);
}

TEST_F(TexturePicture, AGainMultipliesTheDifferenceOfTexelsToTheirVertices) {
  put_textures();
  const double own = in_linear(100);
  for (uint32_t slot = 0; slot < textures_.size(); ++slot) {
    const std::vector<Rgba8> same(meshes_[slot].positions.size(), kGrey);
    const std::vector<TexelChange> texels(same.size(), texel_change(kGrey, Vec3f::Zero(), 2));
    ASSERT_TRUE(raster_.colour_page(slot, same, texels).is_ok());
  }
  EXPECT_GT(part_alike(draw(kUnlit), -own, 2), 0.97);
}

TEST_F(TexturePicture, OtherColouringsAndPagesWithoutATextureLookAsBefore) {
  const Image grey = draw(kUnlit), clay = draw();
  put_textures();
  EXPECT_EQ(draw().rgb, clay.rgb);
  EXPECT_NE(draw(kUnlit).rgb, grey.rgb);
  for (uint32_t slot = 0; slot < textures_.size(); ++slot)
    ASSERT_TRUE(raster_.texture_page(slot, nullptr).is_ok());
  EXPECT_EQ(draw(kUnlit).rgb, grey.rgb);
  put_textures();
  for (uint32_t slot = 0; slot < textures_.size(); ++slot)
    ASSERT_TRUE(raster_.upload_page(slot, meshes_[slot]).is_ok());
  EXPECT_EQ(draw(kUnlit).rgb, grey.rgb);
}

TEST_F(TexturePicture, AFarTextureIsSmooth) {
  put_textures();
  camera_.distance *= 3;
  EXPECT_GT(part_alike(draw(kUnlit)), 0.9);
}

TEST_F(TexturePicture, LooksAsWithOpenGL) {
  expect_twins();
}

/// OpenGL ES 3.0 is what browsers have.
class EmbeddedTexturePicture : public TexturePicture {
  GlKind kind() const override { return GlKind::kEmbedded; }
};

TEST_F(EmbeddedTexturePicture, LooksAsThatOfProcessors) {
  expect_twins();
}

TEST_F(TexturePicture, OpenGLShowsATextureUntilItGoes) {
  const Image grey = draw_by_gl(kUnlit);
  put_textures();
  draw(kUnlit);  // shows pages to part_alike()
  EXPECT_GT(part_alike(draw_by_gl(kUnlit)), 0.98);
  ASSERT_TRUE(gl_->texture_page(0, nullptr).is_ok());
  const Image partly = draw_by_gl(kUnlit);
  EXPECT_NE(partly.rgb, grey.rgb);
  for (uint32_t slot = 1; slot < textures_.size(); ++slot)
    ASSERT_TRUE(gl_->upload_page(slot, meshes_[slot]).is_ok());
  EXPECT_EQ(draw_by_gl(kUnlit).rgb, grey.rgb);
}

TEST_F(TexturePicture, UnlitShowsTheColoursAlone) {
  const Image image = draw(kUnlit);
  const uint8_t* middle = image.pixel(kTwinSize.width / 2, kTwinSize.height / 2);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(middle[c], 100, 1);
}

}  // namespace
}  // namespace burnish
