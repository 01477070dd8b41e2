#include "server/prepare/sheets/page_paint.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/mesh/srgb.h"
#include "tests/common/picture/encoding.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/prepare/sheets/painted_ball.h"

namespace burnish {
namespace {

const Vec3d kMiddle = {1 / 3.0, 1 / 3.0, 1 / 3.0};

/// A triangle with a picture of 64 x 64 texels, red rising to the right and green downwards.
class PaintedTriangle : public testing::Test {
 protected:
  PaintedTriangle() {
    surface_.mesh.vertices = {{1, 1, 1}, {9, 1, 1}, {1, 9, 1}};
    surface_.mesh.triangles = {{0, 1, 2}};
    SurfaceTextures& textures = surface_.textures;
    textures.materials.resize(1);
    textures.materials[0].picture = 0;
    textures.pictures.resize(1);
    textures.coordinates = {{0.1f, 0.1f}, {0.9f, 0.1f}, {0.1f, 0.9f}};
    textures.triangles = {{0, {0, 1, 2}}};
    const auto picture = bytes_of(png_of(drawn(64, 64, [](uint32_t x, uint32_t y) {
      return Rgba8{static_cast<uint8_t>(4 * x), static_cast<uint8_t>(4 * y), 100, 255};
    })));
    EXPECT_TRUE(tiles_
                    .decode(
                        0, picture, "picture", [](const PictureSize&) { return Status::ok(); },
                        [] { return true; })
                    .is_ok());
  }

  /// Returns the page of the triangle, which begins at another corner there.
  Page page(int turn = 0) const {
    Page page;
    for (int k = 0; k < 3; ++k)
      page.positions.push_back(grid_.quantise(surface_.mesh.vertices[(k + turn) % 3]));
    page.triangles = {{0, 1, 2}};
    page.patches = {{kNoPage, 1}};
    return page;
  }

  /// Returns what a sheet as dense as the picture shows there.
  Texel texel_at(const Vec3d& weights, int turn = 0, const LevelledSeams* seams = nullptr) const {
    const TriangleFinder finder(surface_.mesh, grid_, {});
    const PagePaint paint(page(turn), surface_, tiles_, finder, seams);
    PictureSampler sampler(tiles_);
    return paint.source(sampler, density_).texel(0, weights);
  }

  const PageGrid grid_ = {.origin = Vec3d::Zero(), .side = 16, .bits = 12};
  double density_ = 1;  // texels per step; the picture has a fortieth
  TemporaryFolder folder_;
  TexturedSurface surface_;
  PictureTiles tiles_ = PictureTiles::create(folder_.path(), 1).value();
};

TEST_F(PaintedTriangle, ShowsItsPictureWhicheverCornerComesFirst) {
  const Vec3d near_second(0.1, 0.8, 0.1);
  const Texel texel = texel_at(near_second);
  EXPECT_NEAR(texel[0], 4 * (0.74 * 64 - 0.5), 1);
  EXPECT_NEAR(texel[1], 4 * (0.18 * 64 - 0.5), 1);
  EXPECT_TRUE(texel_at({0.8, 0.1, 0.1}, 1).isApprox(texel, 0.01f));
  EXPECT_TRUE(texel_at({0.1, 0.1, 0.8}, 2).isApprox(texel, 0.01f));
}

TEST_F(PaintedTriangle, CountsItsTexelsAndArea) {
  const TriangleFinder finder(surface_.mesh, grid_, {});
  const PagePaint paint(page(), surface_, tiles_, finder);
  EXPECT_NEAR(paint.used_texels(), 0.8 * 0.8 * 64 * 64 / 2, 0.1);
  EXPECT_NEAR(paint.needed_density(), 0.8 * 64 / 2048, 1e-4);
  EXPECT_EQ(paint.lost_triangles(), 0u);
}

TEST_F(PaintedTriangle, FactorAndVertexColoursMultiplyInLinearLight) {
  surface_.textures.materials[0].factor = Vec3f(1, 1, 0.5f);
  surface_.mesh.colours.assign(3, {255, 255, 100, 255});
  const float linear = linear_of_srgb(100);
  EXPECT_NEAR(texel_at(kMiddle)[2], srgb_byte(linear * linear * 0.5f), 1);
}

TEST_F(PaintedTriangle, FactorsOfLevelledSeamsMultiplyBetweenTheCornersInLinearLight) {
  LevelledSeams seams;
  seams.points = {2, 0, 1};
  seams.factors = {{0.5f, 1, 1.5f}, {1, 2, 1}, {0.25f, 1, 1}};
  const Vec3d near_second(0.1, 0.8, 0.1);
  const Vec3f factor = 0.1f * seams.factors[2] + 0.8f * seams.factors[0] + 0.1f * seams.factors[1];
  const Texel plain = texel_at(near_second), levelled = texel_at(near_second, 0, &seams);
  for (int i = 0; i < 3; ++i) {
    const auto byte = static_cast<uint8_t>(std::lround(plain[i]));
    EXPECT_NEAR(levelled[i], srgb_byte(linear_of_srgb(byte) * factor[i]), 1) << i;
  }
  EXPECT_TRUE(texel_at({0.8, 0.1, 0.1}, 1, &seams).isApprox(levelled, 0.01f));
  EXPECT_TRUE(texel_at({0.1, 0.1, 0.8}, 2, &seams).isApprox(levelled, 0.01f));
}

TEST_F(PaintedTriangle, HasThePlainColourWithoutACoordinate) {
  surface_.textures.materials[0].plain = Vec3f(1, 0.5f, 0);
  surface_.textures.triangles[0].corners[1] = kNoTexture;
  EXPECT_EQ(texel_at(kMiddle), Texel(255, srgb_byte(0.5f), 0, 255));
}

TEST_F(PaintedTriangle, OnACoarseSheetShowsMeansOfItsPicture) {
  density_ = 1e-5;  // the whole picture is less than a texel
  const Texel texel = texel_at(kMiddle);
  EXPECT_NEAR(texel[0], 4 * 31.5, 2);
  EXPECT_NEAR(texel[1], 4 * 31.5, 2);
}

TEST_F(PaintedTriangle, WithoutAnAreaIsDrawnAllTheSame) {
  surface_.mesh.vertices[2] = surface_.mesh.vertices[1];
  EXPECT_TRUE(texel_at(kMiddle).allFinite());
}

}  // namespace
}  // namespace burnish
