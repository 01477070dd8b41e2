#include "client/scene/null_renderer.h"

#include <gtest/gtest.h>

#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

TEST(NullRenderer, RemembersWhatItWasAskedToDraw) {
  NullRenderer renderer;
  const TriangleMesh mesh = make_test_sphere(Vec3d::Zero(), 1, 8);
  ASSERT_TRUE(renderer.upload_mesh(make_view_mesh(mesh)).is_ok());
  Camera camera;
  camera.azimuth_degrees = 12;
  ASSERT_TRUE(renderer.draw(camera, {32, 24}, {}).is_ok());
  EXPECT_EQ(renderer.triangle_count(), mesh.triangles.size());
  EXPECT_EQ(renderer.draw_count(), 1u);
  EXPECT_EQ(renderer.camera().azimuth_degrees, 12);
  EXPECT_EQ(renderer.read_pixels().value().rgb.size(), size_t{3 * 32 * 24});
}

TEST(NullRenderer, RefusesToReadBeforeTheFirstPictureAndAbsurdSizes) {
  NullRenderer renderer;
  EXPECT_EQ(renderer.read_pixels().status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(renderer.draw({}, {8, 8}, {}).code(), StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace burnish
