#include "client/pages/picture_pace.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Draws pictures of a scan of so many triangles, on a card that takes `fixed_ms` and a millisecond
/// for each `per_ms` triangles. Returns the milliseconds of the last one.
double draw(PicturePace& pace, uint64_t scan, double fixed_ms, double per_ms, int pictures = 40) {
  double ms = 0;
  for (int i = 0; i < pictures; ++i) {
    const uint64_t most = pace.triangles_max();
    const uint64_t triangles = most == 0 ? scan : std::min(scan, most);
    ms = fixed_ms + static_cast<double>(triangles) / per_ms;
    pace.on_picture(triangles, ms);
  }
  return ms;
}

TEST(PicturePace, AFastCardHasNoLimit) {
  PicturePace pace;
  draw(pace, 2'000'000, 5, 100'000);
  EXPECT_EQ(pace.triangles_max(), 0u);
}

TEST(PicturePace, ASlowCardComesToTenPicturesASecond) {
  PicturePace pace;
  EXPECT_NEAR(draw(pace, 150'000, 40, 150), PicturePace::kPictureMs, 30);
  EXPECT_LT(pace.triangles_max(), 20'000u);
}

TEST(PicturePace, ACardThatIsSlowWithoutTrianglesKeepsSome) {
  PicturePace pace;
  draw(pace, 150'000, 500, 150);
  EXPECT_EQ(pace.triangles_max(), PicturePace::kTrianglesMin);
}

TEST(PicturePace, ASlowPictureOfTheScanBeforeIsNoLimit) {
  PicturePace pace;
  pace.on_picture(0, 2'000);
  EXPECT_EQ(pace.triangles_max(), 0u);
}

TEST(PicturePace, AFewFastPicturesOfASmallScanTellNothing) {
  PicturePace pace;
  draw(pace, 150'000, 40, 150);
  const uint64_t most = pace.triangles_max();
  draw(pace, 100, 10, 150);
  EXPECT_EQ(pace.triangles_max(), most);
}

TEST(PicturePace, TheLimitGoesWhereTheCardHasBecomeFast) {
  PicturePace pace;
  draw(pace, 2'000'000, 40, 150);
  EXPECT_GT(pace.triangles_max(), 0u);
  draw(pace, 2'000'000, 5, 100'000);
  EXPECT_EQ(pace.triangles_max(), 0u);
}

}  // namespace
}  // namespace burnish
