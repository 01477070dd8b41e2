#include <algorithm>

#include "common/generate/generate.h"
#include "tests/client/gl/raw_stage.h"
#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

constexpr int kMiddleX = kRawSize.width / 2, kMiddleY = kRawSize.height / 2;
const Lighting kRadiance{.kind = LightKind::kRadiance};
const Lighting kCavity{.kind = LightKind::kCavity};
const Lighting kOccluded{.occlusion = 1};

class LightPicture : public RawStage {
 protected:
  // A sheet with a bump or a hollow, seen from the front. Its ridges by vertex shine in clay alone.
  void show_sheet(double height) { show(make_sheet(200, 1, height)); }
  void show_sphere() { show(make_test_sphere(Vec3d::Zero(), 1)); }

  // A sheet with a small bump, seen from far away.
  void show_small_bump() {
    show_sheet(0.02);
    camera_.distance *= 4;
  }

  // The range of luminance around the middle of the picture.
  static double contrast(const Image& image) {
    double low = 255, high = 0;
    for (int y = kMiddleY - 20; y < kMiddleY + 20; ++y)
      for (int x = kMiddleX - 20; x < kMiddleX + 20; ++x) {
        low = std::min(low, luminance_at(image, x, y));
        high = std::max(high, luminance_at(image, x, y));
      }
    return high - low;
  }

  // Bytes of two pictures may differ by one: averages of samples may be rounded in two ways.
  static int largest_difference(const Image& a, const Image& b) {
    int largest = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
      largest = std::max(largest, std::abs(a.rgb[i] - b.rgb[i]));
    return largest;
  }

  // Pixels that the surface covers, in part or as a whole.
  std::vector<bool> covered(const Image& image, const Image& background) const {
    std::vector<bool> pixels;
    for (int y = 0; y < kRawSize.height; ++y)
      for (int x = 0; x < kRawSize.width; ++x)
        pixels.push_back(
            !std::equal(image.pixel(x, y), image.pixel(x, y) + 3, background.pixel(x, y)));
    return pixels;
  }
};

TEST_F(LightPicture, RadianceScalingRaisesTheContrastOfABump) {
  show_small_bump();
  EXPECT_GT(contrast(draw(kRadiance)), 1.3 * contrast(draw()));
}

TEST_F(LightPicture, RadianceScalingAndCavityKeepAPlaneAsItIs) {
  show_sheet(0);
  const Image clay = draw();
  EXPECT_LE(largest_difference(draw(kRadiance), clay), 1);
  EXPECT_LE(largest_difference(draw(kCavity), clay), 1);
}

TEST_F(LightPicture, MoreRadianceGivesMoreContrast) {
  show_small_bump();
  Lighting weak = kRadiance;
  weak.radiance = 0.3;
  EXPECT_GT(contrast(draw(kRadiance)), 1.2 * contrast(draw(weak)));
}

TEST_F(LightPicture, CavityDarkensAHollowByItsValleyAndBrightensABumpByItsRidge) {
  Lighting none = kCavity;
  none.ridge = none.valley = 0;
  Lighting valley = none, ridge = none;
  valley.valley = ridge.ridge = 2;
  show_sheet(-0.1);
  EXPECT_LT(luminance_at(draw(valley), kMiddleX, kMiddleY),
            luminance_at(draw(none), kMiddleX, kMiddleY) - 5);
  show_sheet(0.1);
  EXPECT_GT(luminance_at(draw(ridge), kMiddleX, kMiddleY),
            luminance_at(draw(none), kMiddleX, kMiddleY) + 5);
}

TEST_F(LightPicture, RakingLightFromTheLeftBrightensLeftSlopesAlone) {
  show_sphere();
  const Image image =
      draw({.kind = LightKind::kRaking, .azimuth_degrees = 180, .elevation_degrees = 10});
  const double left = luminance_at(image, kMiddleX - 80, kMiddleY);
  const double right = luminance_at(image, kMiddleX + 80, kMiddleY);
  EXPECT_GT(left, right + 100);
}

TEST_F(LightPicture, ALampFromAboveBrightensUpperSlopes) {
  show_sphere();
  const Image image = draw({.azimuth_degrees = 90, .elevation_degrees = 10});
  EXPECT_GT(luminance_at(image, kMiddleX, kMiddleY - 80),
            luminance_at(image, kMiddleX, kMiddleY + 80) + 60);
}

TEST_F(LightPicture, OcclusionDarkensAHollowAndNeitherAPlaneNorASphere) {
  show_sheet(0);
  EXPECT_LE(largest_difference(draw(kOccluded), draw()), 1);
  show_sphere();
  EXPECT_NEAR(luminance_at(draw(kOccluded), kMiddleX, kMiddleY),
              luminance_at(draw(), kMiddleX, kMiddleY), 1);
  show_sheet(-0.25);
  EXPECT_LT(luminance_at(draw(kOccluded), kMiddleX, kMiddleY),
            luminance_at(draw(), kMiddleX, kMiddleY) - 15);
}

TEST_F(LightPicture, OcclusionIsTheSameInEveryPictureOfTheSameView) {
  show_sheet(-0.25);
  EXPECT_EQ(draw(kOccluded).rgb, draw(kOccluded).rgb);
}

TEST_F(LightPicture, MatcapsDifferFromEachOtherAndKnowNoLamp) {
  show_sphere();
  std::vector<Image> images;
  for (const LightKind kind : {LightKind::kCeramic, LightKind::kBronze, LightKind::kSlopes}) {
    images.push_back(draw({.kind = kind}));
    EXPECT_EQ(draw({.kind = kind, .azimuth_degrees = 0}).rgb, images.back().rgb);
  }
  for (int i = 0; i < 3; ++i)
    EXPECT_GT(std::abs(luminance_at(images[i], kMiddleX, kMiddleY) -
                       luminance_at(images[(i + 1) % 3], kMiddleX, kMiddleY)),
              10);
}

TEST_F(LightPicture, LightOfTheSurroundingsKeepsSilhouetteAndBackground) {
  show_sphere();
  const Image clay = draw(), scaled = draw(kRadiance), occluded = draw(kOccluded);
  const Image background = draw_nothing();
  EXPECT_EQ(covered(scaled, background), covered(clay, background));
  EXPECT_EQ(covered(occluded, background), covered(clay, background));
}

TEST_F(LightPicture, RingsKeepTheirColourInEveryLight) {
  show_sheet(-0.1);
  DrawStyle style{.rings = {{Vec3d(0.5, 0.5, 0), 0.15, Vec3f(1, 0, 0)}}};
  style.lighting = {.kind = LightKind::kRadiance, .occlusion = 1};
  const Image image = draw_styled(style);
  int red = 0;
  for (int y = 0; y < kRawSize.height; ++y)
    for (int x = 0; x < kRawSize.width; ++x)
      red += image.pixel(x, y)[0] > 250 && image.pixel(x, y)[1] < 5;
  EXPECT_GT(red, 100);
}

TEST_F(LightPicture, WithoutPerspectiveASphereHasTheAreaOfItsRadiusWhereverItIs) {
  camera_.orthographic = true;
  const auto area_at = [&](double depth) {
    TriangleMesh mesh = make_test_sphere(Vec3d(0, 0, depth), 0.5);
    show(mesh);
    camera_.target = Vec3d::Zero();
    camera_.distance = 6;
    camera_.scene_radius = 5;
    const Image sphere = draw();
    const std::vector<bool> pixels = covered(sphere, draw_nothing());
    return std::count(pixels.begin(), pixels.end(), true);
  };
  const auto middle = area_at(0);
  EXPECT_GT(middle, 1000);
  EXPECT_NEAR(area_at(3), middle, 4);
  EXPECT_NEAR(area_at(-3), middle, 4);
}

TEST_F(LightPicture, RadianceScalingKeepsAPlaneWithoutPerspectiveToo) {
  camera_.orthographic = true;
  camera_.azimuth_degrees = 30;
  show_sheet(0);
  EXPECT_LE(largest_difference(draw(kRadiance), draw()), 1);
}

}  // namespace
}  // namespace burnish
