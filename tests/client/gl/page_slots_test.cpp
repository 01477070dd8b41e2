#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

using testing::HasSubstr;

class PageSlots : public PageStage {
 protected:
  void SetUp() override {
    PageStage::SetUp();
    show(split_into_pages(make_icosphere(4, 1), 1280));
  }

  void move_and_mark(uint32_t slot) {
    const PageMesh& mesh = meshes_[slot];
    move(slot, random_moves(split_.pages[slot].positions, slot));
    const std::vector<VertexMark> marks(mesh.positions.size(), VertexMark{-90, 200});
    ASSERT_TRUE(renderer_->mark_page(slot, marks).is_ok());
  }
};

// All that a slot holds: displacements, values and tints show.
constexpr Colouring kColourings[] = {Colouring::kClay, Colouring::kCells, Colouring::kDisplacement,
                                     Colouring::kScan};

TEST_F(PageSlots, AReusedSlotShowsNothingOfThePageBefore) {
  for (const Colouring colouring : kColourings) {
    const DrawStyle style{.colouring = colouring, .tint = Vec3f(1, 0, 0)};
    put(0, meshes_[2]);
    const Image expected = draw(style, {{0, 0, all_of(2).count}});
    put(1, meshes_[1]);
    move_and_mark(1);
    EXPECT_GT(count_different(draw(style, {all_of(1)}), expected), 1000);
    put(1, meshes_[2]);
    EXPECT_EQ(count_different(draw(style, {{1, 0, all_of(2).count}}), expected), 0);
  }
}

TEST_F(PageSlots, TrianglesBehindThePageOfASlotAreRefused) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // the driver has threads
  Page small;
  small.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  small.triangles = {{0, 1, 2}};
  put(0, make_page_mesh(small, split_.grid));
  EXPECT_DEATH(draw({}, {{0, 0, 2}}), "inside the page");
  EXPECT_DEATH(draw({}, {{0, 1, 1}}), "inside the page");
  EXPECT_DEATH(draw({}, {{4, 0, 1}}), "slots are reserved");
  surface_->open(space_);
  EXPECT_DEATH(draw({}, {{0, 0, 1}}), "inside the page");
}

TEST_F(PageSlots, MoreRoomKeepsWhatTheSlotsHold) {
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot) move_and_mark(slot);
  const DrawStyle style{.colouring = Colouring::kCells, .tint = Vec3f(1, 0, 0)};
  const Image before = draw(style);
  ASSERT_TRUE(surface_->reserve(100).is_ok());
  EXPECT_EQ(count_different(draw(style), before), 0);
  put(99, meshes_[0]);
  EXPECT_EQ(count_different(draw(style), before), 0);
}

TEST_F(PageSlots, AFailedReserveLeavesEverythingAsItWas) {
  move_and_mark(2);
  const Image before = draw();
  const Status above = surface_->reserve(kPageSlotsMax + 1);
  EXPECT_EQ(above.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(above.message(), HasSubstr("262145"));
  const Status driver = surface_->reserve(kPageSlotsMax);  // 26 GB
  if (driver.is_ok()) GTEST_SKIP() << "this card has room for all slots";
  EXPECT_EQ(driver.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(driver.message(), HasSubstr("262144"));
  EXPECT_EQ(count_different(draw(), before), 0);
  EXPECT_TRUE(surface_->reserve(5).is_ok());
  EXPECT_EQ(count_different(draw(), before), 0);
}

}  // namespace
}  // namespace burnish
