#include "server/prepare/sheets/count_texels.h"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/common/picture/encoding.h"
#include "tests/server/prepare/sheets/painted_ball.h"

namespace burnish {
namespace {

/// Triangles that show half of a picture of 64 x 32 texels each.
class CountTexels : public testing::Test {
 protected:
  CountTexels() {
    textures_.materials.resize(1);
    textures_.materials[0].picture = 0;
    textures_.pictures = {{"skin.png", [this] { return file_; }}};
    textures_.coordinates = {{0, 0}, {1, 0}, {0, 1}, {9, 0}};
    textures_.triangles = {{0, {0, 1, 2}}, {0, {0, 3, 2}}, {kNoTexture, {0, 1, 2}}};
  }

  Result<CountedTexels> count(const Progress& progress = {}) const {
    return count_texels(textures_, "scan", {}, progress);
  }

  SurfaceTextures textures_;
  Result<std::vector<uint8_t>> file_ = bytes_of(png_of(drawn(64, 32, [](uint32_t, uint32_t) {
    return Rgba8{1, 2, 3, 255};
  })));
};

TEST_F(CountTexels, ATriangleHasThoseInsideItAndRepeatsCount) {
  const CountedTexels counted = count().value();
  ASSERT_EQ(counted.of_triangle.size(), 3u);
  EXPECT_FLOAT_EQ(counted.of_triangle[0], 64 * 32 / 2);
  EXPECT_FLOAT_EQ(counted.of_triangle[1], 9 * 64 * 32 / 2);
  EXPECT_FLOAT_EQ(counted.of_triangle[2], 0);
  EXPECT_DOUBLE_EQ(counted.of_page_max, 512 * 512);
}

TEST_F(CountTexels, AFileThatIsNoPictureHasNone) {
  file_ = bytes_of("GIF89a");
  EXPECT_TRUE(count()->of_triangle.empty());
  file_ = not_found("skin.png");
  EXPECT_TRUE(count()->of_triangle.empty());
}

TEST_F(CountTexels, ManyLargePicturesMakeFullerPagesInsteadOfMore) {
  file_ = bytes_of(png_of(drawn(1024, 1024, [](uint32_t, uint32_t) {
    return Rgba8{1, 2, 3, 255};
  })));
  textures_.pictures.resize(64, textures_.pictures[0]);
  textures_.coordinates[3] = {1e6f, 0};
  textures_.triangles.assign(100'000, {0, {0, 3, 2}});
  const CountedTexels counted = count().value();
  EXPECT_NEAR(counted.of_page_max, 100'000 / 1024.0 * 1024 * 1024, 1);
}

TEST_F(CountTexels, APictureThatRepeatsOftenMakesNoPageBeyondSixteenOfItself) {
  textures_.coordinates[3] = {1e6f, 0};
  const CountedTexels counted = count().value();
  EXPECT_NEAR(counted.of_page_max, 1024 * 1024 + 64 * 32 / 2, 1);
}

TEST_F(CountTexels, TrianglesThatEachShowAPictureManyTimesShareAPage) {
  textures_.coordinates[3] = {1e6f, 0};
  textures_.triangles.assign(100, {0, {0, 3, 2}});
  const CountedTexels counted = count().value();
  const auto& texels = counted.of_triangle;
  EXPECT_LE(std::accumulate(texels.begin(), texels.end(), 0.0), counted.of_page_max);
}

TEST_F(CountTexels, HearsACancelAndALackOfRoom) {
  EXPECT_EQ(count([](std::string_view, double) { return false; }).status().code(),
            StatusCode::kCancelled);
  file_ = resource_exhausted("skin.png is too much");
  EXPECT_EQ(count().status().code(), StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace burnish
