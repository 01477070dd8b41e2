#include "common/picture/sample_texture.h"

#include <limits>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr TextureWraps kClamped = {TextureWrap::kClamp, TextureWrap::kClamp};
constexpr TextureWraps kMirrored = {TextureWrap::kMirror, TextureWrap::kMirror};

/// Two columns, 0 and 200, and two rows, 0 and 100 in green.
Picture quad() {
  return {2, 2, {{0, 0, 0, 255}, {200, 0, 0, 255}, {0, 100, 0, 255}, {200, 100, 0, 255}}};
}

TEST(SampleTexture, CentresOfPixelsAreExact) {
  EXPECT_EQ(sample_texture(quad(), 0.25, 0.25), (Rgba8{0, 0, 0, 255}));
  EXPECT_EQ(sample_texture(quad(), 0.75, 0.25), (Rgba8{200, 0, 0, 255}));
  EXPECT_EQ(sample_texture(quad(), 0.25, 0.75), (Rgba8{0, 100, 0, 255}));
}

TEST(SampleTexture, BetweenCentresColoursAreMixed) {
  EXPECT_EQ(sample_texture(quad(), 0.5, 0.5), (Rgba8{100, 50, 0, 255}));
  EXPECT_EQ(sample_texture(quad(), 0.375, 0.25), (Rgba8{50, 0, 0, 255}));
}

TEST(SampleTexture, BordersFollowTheWrap) {
  EXPECT_EQ(sample_texture(quad(), 0, 0.25)[0], 100);  // half of the other side
  EXPECT_EQ(sample_texture(quad(), 1, 0.25, kClamped)[0], 200);
  EXPECT_EQ(sample_texture(quad(), 0, 0.25, kClamped)[0], 0);
  EXPECT_EQ(sample_texture(quad(), 0, 0.25, kMirrored)[0], 0);
}

TEST(SampleTexture, CoordinatesBeyondTheBordersFollowTheWrap) {
  EXPECT_EQ(sample_texture(quad(), -2.25, 3.25)[0], 200);
  EXPECT_EQ(sample_texture(quad(), 1.25, 0.25, kMirrored)[0], 200);
  EXPECT_EQ(sample_texture(quad(), 2.25, 0.25, kMirrored)[0], 0);
  EXPECT_EQ(sample_texture(quad(), 7, 0.25, kClamped)[0], 200);
}

TEST(SampleTexture, CoordinatesThatAreNotFiniteCountAsZero) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sample_texture(quad(), nan, 0.25), sample_texture(quad(), 0, 0.25));
  EXPECT_EQ(sample_texture(quad(), 1e300, 0.25)[3], 255);
}

}  // namespace
}  // namespace burnish
