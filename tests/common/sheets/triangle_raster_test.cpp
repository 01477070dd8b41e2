#include "common/sheets/triangle_raster.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(TriangleRaster, TrianglesAroundAPointCoverEachPixelOnce) {
  std::mt19937 random(1);
  const std::array<Vec2d, 4> rim = {Vec2d(0, 0), Vec2d(32, 0), Vec2d(32, 32), Vec2d(0, 32)};
  for (int turn = 0; turn < 200; ++turn) {
    // Halves lie on centres of pixels: the hard case.
    const Vec2d middle(1 + 0.5 * (random() % 60), 1 + 0.5 * (random() % 60));
    std::vector<int> covers(32 * 32, 0);
    for (int k = 0; k < 4; ++k)
      draw_triangle({rim[k], rim[(k + 1) % 4], middle}, 32, 32,
                    [&](int x, int y, const Vec3d&) { ++covers[32 * y + x]; });
    for (const int count : covers) ASSERT_EQ(count, 1) << middle.transpose();
  }
}

TEST(TriangleRaster, WeightsAreThoseOfTheCorners) {
  const std::array<Vec2d, 3> corners = {Vec2d(0.25, 0.5), Vec2d(19, 3), Vec2d(5, 17)};
  size_t pixels = 0;
  draw_triangle(corners, 32, 32, [&](int x, int y, const Vec3d& weights) {
    const Vec2d at = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    EXPECT_NEAR(at.x(), x + 0.5, 1e-9);
    EXPECT_NEAR(at.y(), y + 0.5, 1e-9);
    ++pixels;
  });
  EXPECT_GT(pixels, 100u);
}

TEST(TriangleRaster, ClockwiseAndFarTrianglesAreNotDrawn) {
  const auto pixels = [](const std::array<Vec2d, 3>& corners) {
    size_t count = 0;
    draw_triangle(corners, 8, 8, [&](int, int, const Vec3d&) { ++count; });
    return count;
  };
  EXPECT_EQ(pixels({Vec2d(-9, -9), Vec2d(99, -9), Vec2d(-9, 99)}), 64u);
  EXPECT_EQ(pixels({Vec2d(-9, -9), Vec2d(-9, 99), Vec2d(99, -9)}), 0u);
  EXPECT_EQ(pixels({Vec2d(-9, -9), Vec2d(2e6, -9), Vec2d(-9, 99)}), 0u);
  EXPECT_EQ(pixels({Vec2d(-9, -9), Vec2d(std::nan(""), -9), Vec2d(-9, 99)}), 0u);
}

}  // namespace
}  // namespace burnish
