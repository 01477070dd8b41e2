#include <gtest/gtest.h>

#include "client/scene/displaced_page.h"
#include "client/scene/null_page_renderer.h"
#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

class PagePicks : public PageStage {
 protected:
  void SetUp() override {
    PageStage::SetUp();
    show(split_into_pages(make_icosphere(4, 1), 700));
    reference_.open(space_);
    ASSERT_TRUE(reference_.reserve(static_cast<uint32_t>(meshes_.size())).is_ok());
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      moves_.push_back(random_moves(split_.pages[slot].positions, 9));
      move(slot, moves_[slot]);
      ASSERT_TRUE(reference_.upload_page(slot, meshes_[slot]).is_ok());
      ASSERT_TRUE(reference_.move_page(slot, moves_[slot], {}, {}).is_ok());
    }
    draw();  // moves the pages
  }

  // Halves of pages, in another order than the slots'.
  std::vector<PatchRange> patches() const {
    std::vector<PatchRange> patches;
    for (const PatchRange& page : all()) {
      patches.insert(patches.begin(), {page.slot, 0, page.count / 2});
      patches.push_back({page.slot, page.count / 2, page.count - page.count / 2});
    }
    return patches;
  }

  std::optional<PagePick> pick(PageRenderer& renderer, int x, int y, bool original) {
    return renderer.pick(camera_, kStageSize, {x, y}, original, patches()).value();
  }

  std::optional<SurfaceHit> hit(const PagePick& pick, int x, int y, bool original) {
    const std::span<const Vec3f> nowhere;
    const Ray ray = pixel_ray(camera_, kStageSize, Eigen::Vector2d(x + 0.5, y + 0.5));
    return point_on_page_triangle(
        {meshes_[pick.slot], space_, original ? nowhere : moves_[pick.slot]}, ray, pick.triangle);
  }

  NullPageRenderer reference_;
  std::vector<std::vector<Vec3f>> moves_;
};

TEST_F(PagePicks, AreTheTrianglesThatTestsOfAllTrianglesFind) {
  for (const bool original : {false, true}) {
    int hits = 0, same = 0;
    for (int y = 5; y < kStageSize.height; y += 20) {
      for (int x = 5; x < kStageSize.width; x += 20) {
        const auto found = pick(*renderer_, x, y, original);
        const auto expected = pick(reference_, x, y, original);
        hits += expected.has_value();
        same += found == expected;
        if (!found || !expected) continue;
        const auto a = hit(*found, x, y, original), b = hit(*expected, x, y, original);
        ASSERT_TRUE(a && b);
        EXPECT_LT((a->original - b->original).norm(), 1e-3);
        EXPECT_LT((a->displaced - b->displaced).norm(), 1e-3);
      }
    }
    EXPECT_GT(hits, 40);
    EXPECT_GE(same, 300 - 3);  // of 300 pixels; some lie on an edge
  }
}

TEST_F(PagePicks, LieInThePatchThatThePictureShows) {
  const Image empty = draw({}, {});
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
    const std::vector<PatchRange> alone = {all_of(slot)};
    const Image page = draw({}, alone);
    for (int y = 2; y < kStageSize.height; y += 7) {
      for (int x = 2; x < kStageSize.width; x += 7) {
        const auto found = renderer_->pick(camera_, kStageSize, {x, y}, false, alone).value();
        if (!found) continue;
        EXPECT_EQ(found->slot, slot);
        EXPECT_FALSE(same_pixel(page, empty, x, y)) << x << " " << y;
      }
    }
  }
}

TEST_F(PagePicks, NothingIsPickedBesideTheSurfaceOrWithoutPatches) {
  EXPECT_FALSE(pick(*renderer_, 2, 2, false).has_value());
  EXPECT_FALSE(renderer_->pick(camera_, kStageSize, {200, 150}, false, {}).value().has_value());
}

}  // namespace
}  // namespace burnish
