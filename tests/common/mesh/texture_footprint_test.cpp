#include "common/mesh/textures/texture_footprint.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Returns what each corner weighs over all rows that the triangle names.
std::array<double, 3> weights_of(const TextureFootprint& footprint, uint32_t stride) {
  std::array<double, 3> weights = {};
  for (const TexelRows& range : footprint.rows())
    for (uint32_t y = range.first; y <= range.last; ++y)
      if (y % stride == 0)
        footprint.for_each_piece(y, stride, [&](int corner, double, double, double weight) {
          weights[static_cast<size_t>(corner)] += weight;
        });
  return weights;
}

TEST(TextureFootprint, EachCornerOwnsAThirdWithAnyWrap) {
  for (const TextureWrap wrap : {TextureWrap::kRepeat, TextureWrap::kMirror, TextureWrap::kClamp})
    for (const double scale : {0.001, 0.2, 1.0, 9.0, 70.0, 333.0})
      for (const double y : {-250.0, -1.2, 0.0, 7.7, 31.9, 500.1}) {
        const std::array<Eigen::Vector2d, 3> corners = {
            Eigen::Vector2d(3, y), {3 + scale, y + 0.4 * scale}, {3, y + scale}};
        for (const double weight : weights_of({corners, 32, {wrap, wrap}}, 1))
          EXPECT_NEAR(weight, 1.0 / 3, 0.02) << static_cast<int>(wrap) << " " << scale << " " << y;
      }
}

TEST(TextureFootprint, AStrideGivesEachCornerAThirdOfFewerRows) {
  for (const double y : {100.0, -700.0})
    for (const double size : {3900.0, 9000.0})
      for (const TextureWrap wrap :
           {TextureWrap::kRepeat, TextureWrap::kMirror, TextureWrap::kClamp})
        for (const uint32_t height : {700U, 4096U}) {
          const std::array<Eigen::Vector2d, 3> corners = {
              Eigen::Vector2d(3, y), {900, y + 0.8 * size}, {40, y + size}};
          for (const double weight : weights_of({corners, height, {wrap, wrap}}, 32))
            EXPECT_NEAR(weight, 1.0 / 3, 0.02)
                << static_cast<int>(wrap) << " " << y << " " << size << " " << height;
        }
}

}  // namespace
}  // namespace burnish
