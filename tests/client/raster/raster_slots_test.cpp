#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/raster/raster_page_renderer.h"
#include "client/scene/page_surface.h"
#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

using testing::HasSubstr;

constexpr ImageSize kSlotsSize{200, 150};

class RasterSlots : public testing::Test {
 protected:
  void SetUp() override {
    split_ = split_into_pages(make_icosphere(4, 1), 1280);
    space_ = make_page_space(split_.grid, 5);
    for (const Page& page : split_.pages) meshes_.push_back(make_page_mesh(page, split_.grid));
    fill(renderer_);
  }

  void fill(PageRenderer& renderer) {
    renderer.open(space_);
    ASSERT_TRUE(renderer.reserve(static_cast<uint32_t>(meshes_.size())).is_ok());
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
      ASSERT_TRUE(renderer.upload_page(slot, meshes_[slot]).is_ok());
  }

  void move_and_mark(PageRenderer& renderer, uint32_t slot) {
    const std::vector<Vec3f> moves = random_moves(split_.pages[slot].positions, slot);
    const MovedPage moved = displace(meshes_[slot], moves, space_.cell_size);
    ASSERT_TRUE(renderer.move_page(slot, moves, moved.normals, meshes_[slot].ridges).is_ok());
    const std::vector<VertexMark> marks(moves.size(), VertexMark{-90, 200});
    ASSERT_TRUE(renderer.mark_page(slot, marks).is_ok());
    const std::vector<Rgba8> colours(moves.size(), Rgba8{200, 20, 90, 255});
    ASSERT_TRUE(
        renderer.colour_page(slot, colours, std::vector<TexelChange>(colours.size())).is_ok());
  }

  std::vector<PatchRange> all() const {
    std::vector<PatchRange> patches;
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
      patches.push_back({slot, 0, static_cast<uint32_t>(meshes_[slot].triangles.size())});
    return patches;
  }

  Image draw(PageRenderer& renderer, const DrawStyle& style,
             const std::vector<PatchRange>& patches) {
    const Camera camera{
        .target = space_.centre, .distance = 4.5 * space_.unit, .scene_radius = 2 * space_.unit};
    EXPECT_TRUE(renderer.draw(camera, kSlotsSize, style, patches).is_ok());
    return std::move(renderer.read_pixels()).value();
  }

  SplitMesh split_;
  PageSpace space_;
  std::vector<PageMesh> meshes_;
  RasterPageRenderer renderer_{1};
};

TEST_F(RasterSlots, AnyNumberOfThreadsGivesTheSameBits) {
  RasterPageRenderer two(2), three(3);
  fill(two);
  fill(three);
  for (PageRenderer* each : {static_cast<PageRenderer*>(&renderer_),
                             static_cast<PageRenderer*>(&two), static_cast<PageRenderer*>(&three)})
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) move_and_mark(*each, slot);
  for (const RasterSampling sampling : {RasterSampling::kOne, RasterSampling::kFour})
    for (const double occlusion : {0.0, 0.5}) {
      DrawStyle style{.split = 0.4};
      style.lighting.occlusion = occlusion;
      for (RasterPageRenderer* each : {&renderer_, &two, &three}) each->set_sampling(sampling);
      const Image by_one = draw(renderer_, style, all());
      for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(draw(two, style, all()).rgb, by_one.rgb);
        EXPECT_EQ(draw(three, style, all()).rgb, by_one.rgb);
      }
    }
}

TEST_F(RasterSlots, TheOrderOfPatchesDoesNotMatter) {
  std::vector<PatchRange> patches;
  for (const PatchRange& page : all()) {
    patches.push_back({page.slot, 100, page.count - 100});
    patches.push_back({page.slot, 0, 100});
  }
  std::reverse(patches.begin(), patches.end());
  const Image whole = draw(renderer_, {}, all());
  EXPECT_EQ(draw(renderer_, {}, patches).rgb, whole.rgb);
  patches.pop_back();
  EXPECT_NE(draw(renderer_, {}, patches).rgb, whole.rgb);
}

TEST_F(RasterSlots, AReusedSlotShowsNothingOfThePageBefore) {
  const auto only = [this](uint32_t slot, uint32_t page) {
    return std::vector<PatchRange>{
        {slot, 0, static_cast<uint32_t>(meshes_[page].triangles.size())}};
  };
  for (const Colouring colouring :
       {Colouring::kClay, Colouring::kCells, Colouring::kDisplacement, Colouring::kScan}) {
    const DrawStyle style{.colouring = colouring, .tint = Vec3f(1, 0, 0)};
    ASSERT_TRUE(renderer_.upload_page(0, meshes_[2]).is_ok());
    const Image expected = draw(renderer_, style, only(0, 2));
    ASSERT_TRUE(renderer_.upload_page(1, meshes_[1]).is_ok());
    move_and_mark(renderer_, 1);
    EXPECT_NE(draw(renderer_, style, only(1, 1)).rgb, expected.rgb);
    ASSERT_TRUE(renderer_.upload_page(1, meshes_[2]).is_ok());
    EXPECT_EQ(draw(renderer_, style, only(1, 2)).rgb, expected.rgb);
  }
}

TEST_F(RasterSlots, ColoursOfTheDisplacedSurfaceAreNotThoseOfTheOriginal) {
  const Image before = draw(renderer_, {.colouring = Colouring::kScan}, all());
  move_and_mark(renderer_, 0);
  EXPECT_NE(draw(renderer_, {.colouring = Colouring::kScan}, all()).rgb, before.rgb);
  DrawStyle original{.colouring = Colouring::kScan, .original = true};
  const std::vector<VertexMark> none(meshes_[0].positions.size());
  ASSERT_TRUE(renderer_.mark_page(0, none).is_ok());
  EXPECT_EQ(draw(renderer_, original, all()).rgb, before.rgb);
}

TEST_F(RasterSlots, MoreRoomKeepsWhatTheSlotsHold) {
  move_and_mark(renderer_, 2);
  const Image before = draw(renderer_, {}, all());
  ASSERT_TRUE(renderer_.reserve(100).is_ok());
  ASSERT_TRUE(renderer_.reserve(5).is_ok());
  EXPECT_EQ(draw(renderer_, {}, all()).rgb, before.rgb);
  const Status above = renderer_.reserve(kPageSlotsMax + 1);
  EXPECT_EQ(above.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(above.message(), HasSubstr("262145"));
  EXPECT_EQ(draw(renderer_, {}, all()).rgb, before.rgb);
}

TEST_F(RasterSlots, AbsurdSizesAreRefusedAndTheNextPictureIsDrawn) {
  RasterPageRenderer fresh(1);
  EXPECT_EQ(fresh.read_pixels().status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(fresh.draw({}, {15, 100}, {}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(fresh.draw({}, {100, 8193}, {}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(fresh.read_pixels().status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(draw(fresh, {}, {}).size, kSlotsSize);
}

TEST_F(RasterSlots, TrianglesBehindThePageOfASlotAreRefused) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto count = static_cast<uint32_t>(meshes_[0].triangles.size());
  EXPECT_DEATH(draw(renderer_, {}, {{0, 1, count}}), "inside the page");
  EXPECT_DEATH(draw(renderer_, {}, {{77, 0, 1}}), "slots are reserved");
  renderer_.open(space_);
  EXPECT_DEATH(draw(renderer_, {}, {{0, 0, 1}}), "inside the page");
}

}  // namespace
}  // namespace burnish
