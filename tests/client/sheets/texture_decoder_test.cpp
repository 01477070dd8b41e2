#include "client/sheets/texture_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/raster/texel_colour.h"
#include "client/scene/page_mesh.h"
#include "common/sheets/chart_codec.h"
#include "common/sheets/cut_charts.h"
#include "common/sheets/sheet_codec.h"
#include "tests/common/sheets/made_surfaces.h"
#include "tests/common/sheets/made_texture.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr double kWave = 700;
constexpr float kDensity = 0.1f;  // texels per step, which is a file unit here

/// A page with its charts and one sheet, and the grid on which a step is a file unit.
class DecodedTextures : public testing::Test {
 protected:
  DecodedTextures() {
    grid_.side = grid_.steps();
    encoded_.sheet = PageItem::of_sheet(page_.id, 0);
    encoded_.page = std::make_shared<const Page>(page_);
    encoded_.chart_bytes = encode_charts(page_.id, charts_);
    encoded_.sheet_bytes = encode_sheet(sheet_).value();
    encoded_.size = {sheet_.layout.width, sheet_.layout.height};
    encoded_.density = kDensity;
  }

  PageGrid grid_;
  Page page_ = wavy_page(12, 100, 120);
  PageCharts charts_ = cut_charts(page_, kDensity);
  Sheet sheet_ = baked_sheet(page_, charts_, kDensity, pattern_on(page_, kWave), 1);
  EncodedTexture encoded_;
};

TEST_F(DecodedTextures, ShowThePatternAtTheMiddleOfEachTriangle) {
  const DecodedTexture decoded = decode_texture(encoded_, grid_);
  ASSERT_TRUE(decoded.status.is_ok()) << decoded.status.message();
  const PageTexture& texture = *decoded.texture;
  const PageMesh mesh = make_page_mesh(page_, grid_);
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3f middle = Vec3f::Zero();
    Vec3d steps = Vec3d::Zero();
    for (const uint16_t corner : mesh.triangles[t]) {
      middle += mesh.positions[corner] / 3;
      steps += page_.positions[corner].cast<double>() / 3;
    }
    const TextureChart& chart = texture.charts[texture.chart_of_triangle[t]];
    const Eigen::Vector4f at(middle.x(), middle.y(), middle.z(), 1);
    const TexelPoint place{chart.u.dot(at), chart.v.dot(at)};
    const ShadeVector shown = texel_colour(texture, place, {}, {});
    const Texel expected = pattern_at(steps, kWave);
    EXPECT_NEAR(255 * shown.x, expected[0], 16) << t;
    EXPECT_NEAR(255 * shown.y, expected[1], 16) << t;
    EXPECT_NEAR(255 * shown.z, expected[2], 16) << t;
  }
}

TEST_F(DecodedTextures, DamagedRecordsAreNamed) {
  EncodedTexture damaged = encoded_;
  damaged.sheet_bytes.back() ^= 1;
  DecodedTexture decoded = decode_texture(damaged, grid_);
  EXPECT_EQ(decoded.texture, nullptr);
  EXPECT_EQ(decoded.damaged, encoded_.sheet);
  EXPECT_THAT(decoded.status.message(), HasSubstr("checksum"));
  damaged = encoded_;
  damaged.chart_bytes.back() ^= 1;
  decoded = decode_texture(damaged, grid_);
  EXPECT_EQ(decoded.damaged, PageItem::of_charts(page_.id));
}

TEST_F(DecodedTextures, ASheetIsTheOneThatTheDirectoryLists) {
  EncodedTexture other = encoded_;
  other.size.width = 77;
  EXPECT_THAT(decode_texture(other, grid_).status.message(), HasSubstr("77"));
  other = encoded_;
  other.density = 0.7f;
  EXPECT_THAT(decode_texture(other, grid_).status.message(), HasSubstr("0.7"));
  other = encoded_;
  other.sheet.halving = 1;
  EXPECT_THAT(decode_texture(other, grid_).status.message(), HasSubstr("halving 1"));
}

TEST(PageTextures, LevelsAreMeansOfFourTexels) {
  const std::vector<Rgba8> texels = {{0, 0, 0, 255},   {10, 4, 0, 255},  {90, 0, 0, 255},
                                     {20, 8, 0, 255},  {30, 12, 0, 255}, {50, 0, 0, 255},
                                     {100, 0, 0, 255}, {0, 0, 0, 255},   {7, 0, 0, 255}};
  const auto levels = texture_levels(3, 3, texels);
  ASSERT_EQ(levels[1].width, 2);
  EXPECT_EQ(levels[1].texels[0], (Rgba8{15, 6, 0, 255}));
  EXPECT_EQ(levels[1].texels[1], (Rgba8{70, 0, 0, 255}));
  EXPECT_EQ(levels[1].texels[3], (Rgba8{7, 0, 0, 255}));
  EXPECT_EQ(levels[2].width, 1);
}

}  // namespace
}  // namespace burnish
