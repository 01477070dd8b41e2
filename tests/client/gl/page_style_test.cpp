#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/gl/page_stage.h"

namespace burnish {
namespace {

const Eigen::Vector2i kMiddle(200, 150);

class PageStyle : public PageStage {
 protected:
  void SetUp() override {
    PageStage::SetUp();
    show(split_into_pages(make_icosphere(4, 1), 1280));
  }

  // Moves along and against the normal, so that the surface has waves.
  void grow(float cells, float wave = 0) {
    moves_.assign(meshes_.size(), {});
    for (uint32_t slot = 0; slot < meshes_.size(); ++slot) {
      for (const Vec3f& at : meshes_[slot].positions)
        moves_[slot].push_back((cells + wave * std::sin(12 * at.x())) * at.normalized());
      move(slot, moves_[slot]);
    }
  }

  std::array<int, 3> rgb_at(const Image& image, const Eigen::Vector2i& at) const {
    const uint8_t* rgb = image.pixel(at.x(), at.y());
    return {rgb[0], rgb[1], rgb[2]};
  }

  // The original place of what the picture shows.
  std::optional<Vec3d> original_at(int x, int y) {
    const Ray ray = pixel_ray(camera_, kStageSize, Eigen::Vector2d(x + 0.5, y + 0.5));
    const auto hit = surface_->hit(ray, false);
    return hit ? std::optional(hit->point.original) : std::nullopt;
  }

  std::vector<std::vector<Vec3f>> moves_;
};

TEST_F(PageStyle, OutwardMovesAreRedInwardOnesBlueAndTheRangeIsFullColour) {
  const DrawStyle style{.colouring = Colouring::kDisplacement, .displacement = {2, 2}};
  grow(2);
  const auto outwards = rgb_at(draw(style), kMiddle);
  EXPECT_GT(outwards[0], outwards[2] + 40);
  grow(1);
  EXPECT_LT(rgb_at(draw(style), kMiddle)[0] - rgb_at(draw(style), kMiddle)[2],
            outwards[0] - outwards[2] - 10);
  grow(-2);
  const auto inwards = rgb_at(draw(style), kMiddle);
  EXPECT_GT(inwards[2], inwards[0] + 40);
  const auto original = rgb_at(
      draw({.colouring = Colouring::kDisplacement, .displacement = {2, 2}, .original = true}),
      kMiddle);
  EXPECT_NEAR(original[0], original[2], 15);
}

TEST_F(PageStyle, EachEndOfTheColoursHasItsOwnRange) {
  const auto warmth = [&](double move, const ColourEnds& ends) {
    grow(move);
    const auto rgb =
        rgb_at(draw({.colouring = Colouring::kDisplacement, .displacement = ends}), kMiddle);
    return int{rgb[0]} - int{rgb[2]};
  };
  EXPECT_EQ(warmth(2, {1, 8}), warmth(2, {100, 8}));
  EXPECT_LT(warmth(2, {1, 8}), warmth(2, {1, 2}) - 10);
  EXPECT_EQ(warmth(-2, {8, 1}), warmth(-2, {8, 100}));
  EXPECT_GT(warmth(-2, {8, 1}), warmth(-2, {2, 1}) + 10);
}

TEST_F(PageStyle, AFadedPictureIsGrey) {
  const DrawStyle style{.colouring = Colouring::kDisplacement, .faded = true};
  grow(2);
  const auto rgb = rgb_at(draw(style), kMiddle);
  EXPECT_NEAR(rgb[0], rgb[1], 1);
  EXPECT_NEAR(rgb[1], rgb[2], 1);
}

TEST_F(PageStyle, ARingHoldsWhatTheBrushChangesWhereverItIsNow) {
  grow(1, 1);
  const Vec3d front = space_.centre + Vec3d(0, 0, 1);
  const Image ring = draw({.rings = {{front, 0.4, Vec3f(1, 0, 0)}}});
  int drawn = 0;
  for_each_pixel([&](int x, int y) {
    const uint8_t* rgb = ring.pixel(x, y);
    if (rgb[0] < 200 || rgb[1] > 80) return;
    const auto original = original_at(x, y);
    ASSERT_TRUE(original.has_value());
    EXPECT_NEAR((*original - front).norm(), 0.4, 0.04) << x << " " << y;
    ++drawn;
  });
  EXPECT_GT(drawn, 100);
}

TEST_F(PageStyle, NoMoreRingsThanTheLimitAreDrawn) {
  std::vector<Ring> rings(kRingsDrawnMax, {space_.centre + Vec3d(0, 0, 1), 0.4, Vec3f(1, 0, 0)});
  const Image full = draw({.rings = rings});
  rings.push_back({space_.centre + Vec3d(0, 0, 1), 0.6, Vec3f(0, 1, 0)});
  EXPECT_EQ(count_different(draw({.rings = rings}), full), 0);
}

}  // namespace
}  // namespace burnish
