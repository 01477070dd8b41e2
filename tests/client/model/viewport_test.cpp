#include "client/model/view/viewport.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

const Eigen::AlignedBox3d kWideBox(Vec3d(-4, -1, -1), Vec3d(4, 1, 1));

Viewport viewport_of(const ImageSize& size) {
  Viewport viewport;
  viewport.set_size(size);
  viewport.begin(kWideBox, UpAxis::kY);
  return viewport;
}

TEST(Viewport, ShowsTheWholeScanThoughItsSizeIsKnownLater) {
  Viewport viewport = viewport_of({1, 1});
  viewport.set_size({400, 800});
  EXPECT_EQ(viewport.camera, viewport_of({400, 800}).camera);
  EXPECT_FALSE(viewport.camera == viewport_of({1, 1}).camera);
}

TEST(Viewport, AViewThatTheUserHasTurnedStaysInAnotherSize) {
  Viewport viewport = viewport_of({800, 400});
  viewport.camera.azimuth_degrees += 1;
  const Camera turned = viewport.camera;
  viewport.set_size({400, 800});
  EXPECT_EQ(viewport.camera, turned);
}

TEST(Viewport, NoScaleBarAndNoAxesLieOverASurfaceWithoutASession) {
  const Viewport viewport = viewport_of({800, 600});
  EXPECT_FALSE(viewport.scale_bar().has_value());
  EXPECT_FALSE(viewport.axes().has_value());
}

}  // namespace
}  // namespace burnish
