#include "client/raster/triangle_filler.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr ImageSize kFilledSize{40, 30};

Visibility empty_picture(int samples) {
  return {kFilledSize, samples,
          std::vector<SampleKey>(size_t(kFilledSize.width) * kFilledSize.height * samples)};
}

/// Adds one to each sample that a triangle covers.
void count_samples(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c, int samples,
                   std::vector<int>& counts) {
  Visibility picture = empty_picture(samples);
  fill_triangle(picture, {0, kFilledSize.width}, false, a, b, c, 7);
  for (size_t i = 0; i < counts.size(); ++i) counts[i] += picture.keys[i] != kNothingSeen;
}

ScreenVertex at(int x, int y, float nearness = 0.5f) {
  return {x, y, nearness, 0};
}

// Corners on samples, on edges of pixels and anywhere.
TEST(TriangleFiller, TrianglesAroundAPointCoverEachSampleOnce) {
  std::mt19937 random(5);
  const int right = kFilledSize.width * kSubpixels, bottom = kFilledSize.height * kSubpixels;
  for (int round = 0; round < 300; ++round) {
    const int grain = round % 3 == 0 ? 128 : round % 3 == 1 ? 32 : 1;
    const auto place = [&](int end) {
      return static_cast<int>(random() % static_cast<unsigned>(end)) / grain * grain;
    };
    const ScreenVertex middle = at(place(right), place(bottom));
    const ScreenVertex rim[] = {at(0, 0),          at(place(right), 0),
                                at(right, 0),      at(right, place(bottom)),
                                at(right, bottom), at(0, bottom)};
    for (const int samples : {1, 4}) {
      std::vector<int> counts(size_t(kFilledSize.width) * kFilledSize.height * samples);
      for (size_t i = 0; i < std::size(rim); ++i) {
        const ScreenVertex& next = rim[(i + 1) % std::size(rim)];
        if (round % 2 == 0) count_samples(middle, rim[i], next, samples, counts);
        if (round % 2 == 1) count_samples(next, rim[i], middle, samples, counts);
      }
      ASSERT_EQ(std::ranges::count(counts, 1), std::ssize(counts)) << round << " " << samples;
    }
  }
}

TEST(TriangleFiller, TheNearerTriangleIsSeenInAnyOrder) {
  const ScreenVertex far[] = {at(0, 0, 0.2f), at(9000, 0, 0.2f), at(0, 9000, 0.2f)};
  const ScreenVertex near[] = {at(0, 0, 0.3f), at(0, 9000, 0.3f), at(9000, 0, 0.3f)};
  for (const bool is_near_first : {false, true}) {
    Visibility picture = empty_picture(1);
    const ColumnRange columns{0, kFilledSize.width};
    if (is_near_first) fill_triangle(picture, columns, false, near[0], near[1], near[2], 1);
    fill_triangle(picture, columns, true, far[0], far[1], far[2], 0);
    if (!is_near_first) fill_triangle(picture, columns, true, near[0], near[1], near[2], 1);
    EXPECT_EQ(id_of_key(picture.keys[picture.place(5, 5)]), 1u);
    EXPECT_FLOAT_EQ(nearness_of_key(picture.keys[picture.place(5, 5)]), 0.3f);
  }
}

TEST(TriangleFiller, NothingIsFilledPastTheColumnsOrTheFarPlane) {
  Visibility picture = empty_picture(1);
  fill_triangle(picture, {10, 20}, false, at(-90000, -90000), at(900000, 0), at(0, 900000), 1);
  EXPECT_EQ(picture.keys[picture.place(9, 5)], kNothingSeen);
  EXPECT_NE(picture.keys[picture.place(10, 5)], kNothingSeen);
  EXPECT_NE(picture.keys[picture.place(19, 29)], kNothingSeen);
  EXPECT_EQ(picture.keys[picture.place(20, 5)], kNothingSeen);
  Visibility behind = empty_picture(1);
  fill_triangle(behind, {0, 40}, false, at(0, 0, -0.1f), at(9000, 0, -0.1f), at(0, 9000, -0.1f), 1);
  EXPECT_EQ(behind.keys[behind.place(5, 5)], kNothingSeen);
}

}  // namespace
}  // namespace burnish
