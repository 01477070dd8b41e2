#include "client/cli/render/view_textures.h"

#include <algorithm>
#include <optional>

#include <gmock/gmock.h>

#include "common/base/parallel.h"
#include "common/mesh/mesh_format.h"
#include "server/prepare/sheets/decode_pictures.h"
#include "tests/client/cli/render/painted_file.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A painted ball whose textures are baked for pictures.
class ViewTexturesOfABall : public testing::Test {
 protected:
  void read(const PaintedBall& ball) {
    file_.emplace(ball);
    const auto take = [&](const TexturedSurface& read) -> Status {
      ASSIGN_OR_RETURN(pictures_,
                       decode_pictures(read.textures, "ball", file_->folder.path(),
                                       [](uint64_t, uint64_t) { return Status::ok(); }, {}));
      surface_ = read;
      return Status::ok();
    };
    ASSERT_TRUE(read_textured_surface(file_->zip, MeshFormat::kZip, "ball", take).is_ok());
  }

  ViewWish wish(uint64_t bytes_max) const {
    return {picture_camera(options_, referenced_box(surface_.mesh)), options_.size, bytes_max};
  }

  Result<ViewTextures> bake(uint64_t bytes_max = 1'000'000'000) const {
    return bake_view_textures(surface_, pictures_->tiles, wish(bytes_max));
  }

  static uint64_t bytes_of(const ViewTextures& textures) {
    uint64_t bytes = 0;
    for (const auto& texture : textures.of_page) bytes += texture ? texture->bytes() : 0;
    return bytes;
  }

  std::optional<PaintedFile> file_;
  TexturedSurface surface_;
  std::optional<DecodedPictures> pictures_;
  PictureOptions options_ = unlit_picture({640, 480});
};

TEST_F(ViewTexturesOfABall, AreAsDenseAsThePictureNeeds) {
  read({.quads_per_side = 8, .face_texels = 510});
  const uint64_t large = bytes_of(bake().value());
  options_.size = {160, 120};
  const uint64_t small = bytes_of(bake().value());
  EXPECT_LT(small, large / 4);
}

TEST_F(ViewTexturesOfABall, AreNoDenserThanTheScansPictures) {
  read({.quads_per_side = 8, .face_texels = 30});
  const uint64_t whole = bytes_of(bake().value());
  options_.size = {1280, 960};
  EXPECT_EQ(bytes_of(bake().value()), whole);
}

TEST_F(ViewTexturesOfABall, AreSharpWhereATriangleIsLargeInThePicture) {
  read({.quads_per_side = 1, .face_texels = 766});
  options_.size = {1280, 960};
  const ViewTextures textures = bake().value();
  EXPECT_GT(textures.raw.pages.size(), 4u);
  EXPECT_EQ(textures.halvings, 0);
  const double texel_a_pixel = 1 / pixel_length(wish(0).camera, options_.size);
  for (const auto& texture : textures.of_page)
    EXPECT_GT(texture->charts[0].u.head<3>().norm() / textures.raw.space.unit, texel_a_pixel);
}

TEST_F(ViewTexturesOfABall, OutsideThePictureAreNotMade) {
  read({.quads_per_side = 120, .face_texels = 62});
  options_.zoom = 20;
  const ViewTextures textures = bake().value();
  const auto is_made = [](const auto& texture) { return texture != nullptr; };
  EXPECT_TRUE(std::ranges::any_of(textures.of_page, is_made));
  EXPECT_FALSE(std::ranges::all_of(textures.of_page, is_made));
}

TEST_F(ViewTexturesOfABall, AreSharpWhereThePictureEnds) {
  read({.quads_per_side = 18, .face_texels = 766});
  options_.size = {80, 60};
  options_.zoom = 16;
  const ViewTextures textures = bake().value();
  const double texel_a_pixel = 1 / pixel_length(wish(0).camera, options_.size);
  for (const auto& texture : textures.of_page) {
    if (!texture) continue;
    EXPECT_GT(texture->charts[0].u.head<3>().norm() / textures.raw.space.unit, texel_a_pixel);
  }
}

TEST_F(ViewTexturesOfABall, AreHalvedUntilTheyKeepTheLimit) {
  read({.quads_per_side = 8, .face_texels = 254});
  const ViewTextures whole = bake().value();
  ASSERT_EQ(whole.halvings, 0);
  const uint64_t limit = bytes_of(whole) / 3;
  const ViewTextures halved = bake(limit).value();
  EXPECT_GT(halved.halvings, 0);
  EXPECT_LE(bytes_of(halved), limit);
}

TEST_F(ViewTexturesOfABall, ThatNoHalvingMakesSmallEnoughNameTheLimit) {
  read({.quads_per_side = 8, .face_texels = 254});
  const auto refused = bake(1000);
  EXPECT_EQ(refused.status().code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.status().message(), HasSubstr("1000"));
}

TEST_F(ViewTexturesOfABall, AreTheSameForAnyNumberOfThreads) {
  read({.quads_per_side = 24, .face_texels = 254});
  const ViewTextures many = bake().value();
  const int threads = thread_count();
  use_threads(1);
  const ViewTextures one = bake().value();
  use_threads(threads);
  ASSERT_EQ(one.of_page.size(), many.of_page.size());
  for (size_t i = 0; i < one.of_page.size(); ++i) {
    ASSERT_EQ(one.of_page[i] == nullptr, many.of_page[i] == nullptr);
    if (!one.of_page[i]) continue;
    EXPECT_EQ(one.of_page[i]->levels[0].texels, many.of_page[i]->levels[0].texels);
    EXPECT_EQ(one.of_page[i]->chart_of_triangle, many.of_page[i]->chart_of_triangle);
  }
}

}  // namespace
}  // namespace burnish
