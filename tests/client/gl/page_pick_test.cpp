#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

/// A rough sphere whose pages have moved.
class PagePicks : public PageStage {
 protected:
  void SetUp() override {
    PageStage::SetUp();
    show(split_into_pages(make_icosphere(4, 1), 700));
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot)
      move(slot, random_moves(split_.pages[slot].positions, 9));
  }

  std::optional<PageHit> hit(int x, int y, bool original = false) const {
    const Ray ray = pixel_ray(camera_, kStageSize, Eigen::Vector2d(x + 0.5, y + 0.5));
    return surface_->hit(ray, original);
  }
};

TEST_F(PagePicks, HitWhatThePictureShowsAndNothingElse) {
  const Image empty = draw({}, {});
  for (const bool original : {false, true}) {
    const Image picture = draw({.original = original});
    int hits = 0, wrong = 0;
    for (int y = 2; y < kStageSize.height; y += 3) {
      for (int x = 2; x < kStageSize.width; x += 3) {
        const bool is_shown = !same_pixel(picture, empty, x, y);
        hits += is_shown;
        wrong += is_shown != hit(x, y, original).has_value();
      }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_LT(wrong, hits / 100) << "a few pixels at the rim are partly covered";
  }
}

TEST_F(PagePicks, LieInThePageThatIsDrawnThere) {
  const Image empty = draw({}, {});
  for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
    const Image page = draw({}, {all_of(slot)});
    int wrong = 0, hits = 0;
    for (int y = 2; y < kStageSize.height; y += 7) {
      for (int x = 2; x < kStageSize.width; x += 7) {
        const auto found = hit(x, y);
        if (!found) continue;
        EXPECT_EQ(found->slot, slot);
        ++hits;
        wrong += same_pixel(page, empty, x, y);
      }
    }
    EXPECT_LE(wrong, 1 + hits / 50);
  }
}

TEST_F(PagePicks, NothingIsHitBesideTheSurfaceOrWithoutPatches) {
  draw();
  EXPECT_FALSE(hit(2, 2).has_value());
  EXPECT_TRUE(hit(200, 150).has_value());
  draw({}, {});
  EXPECT_FALSE(hit(200, 150).has_value());
}

}  // namespace
}  // namespace burnish
