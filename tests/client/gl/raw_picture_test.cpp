#include <numbers>

#include <gtest/gtest.h>

#include "client/gl/context_egl.h"
#include "client/gl/gl_page_renderer.h"
#include "client/scene/raw_pages.h"
#include "tests/client/scene/sphere.h"

namespace burnish {
namespace {

constexpr ImageSize kSize{400, 300};

Camera sphere_camera(double distance) {
  Camera camera;
  camera.distance = distance;
  camera.scene_radius = 1.1;
  return camera;
}

class RawPicture : public testing::Test {
 protected:
  void SetUp() override {
    auto context = EglContext::create();
    ASSERT_TRUE(context.is_ok()) << context.status().message();
    context_ = std::move(context).value();
    renderer_ = std::move(GlPageRenderer::create()).value();
  }

  Image draw(const Camera& camera, const DrawStyle& style = {}) {
    const Status drawn = renderer_->draw(camera, kSize, style, patches_);
    EXPECT_TRUE(drawn.is_ok()) << drawn.message();
    return std::move(renderer_->read_pixels()).value();
  }

  void show(const TriangleMesh& mesh) {
    auto patches = upload_pages(make_raw_pages(mesh), *renderer_);
    ASSERT_TRUE(patches.is_ok()) << patches.status().message();
    patches_ = std::move(patches).value();
  }

  Image draw_sphere(const Vec3d& centre, const Camera& camera, const DrawStyle& style = {}) {
    show(make_test_sphere(centre, 1));
    return draw(camera, style);
  }

  std::unique_ptr<EglContext> context_;  // outlives the renderer
  std::unique_ptr<GlPageRenderer> renderer_;
  std::vector<PatchRange> patches_;
};

int count_changed(const Image& a, const Image& b) {
  int count = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x)
      count += !std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y));
  return count;
}

int brightness(const Image& image, int x, int y) {
  const uint8_t* rgb = image.pixel(x, y);
  return rgb[0] + rgb[1] + rgb[2];
}

TEST_F(RawPicture, ASpheresSilhouetteHasTheAreaThatPerspectiveGives) {
  const double distance = 5;
  const Camera camera = sphere_camera(distance);
  const Image background = draw(camera);
  const Image sphere = draw_sphere(Vec3d::Zero(), camera);
  const double half_view = std::tan(15 * std::numbers::pi / 180);
  const double radius_pixels = std::tan(std::asin(1 / distance)) / half_view * (0.5 * kSize.height);
  const double area = std::numbers::pi * radius_pixels * radius_pixels;
  // Every pixel that the edge touches differs: half a pixel around the whole circle.
  const double edge = std::numbers::pi * radius_pixels;
  EXPECT_NEAR(count_changed(sphere, background), area + edge, edge);
}

TEST_F(RawPicture, TheSideTowardsTheKeyLightIsBrighter) {
  const Image image = draw_sphere(Vec3d::Zero(), sphere_camera(5));
  const int lit = brightness(image, kSize.width / 2 - 60, kSize.height / 2 - 60);
  const int dark = brightness(image, kSize.width / 2 + 60, kSize.height / 2 + 60);
  EXPECT_GT(lit, dark + 150);
}

TEST_F(RawPicture, RowsGoFromTopToBottom) {
  const Image image = draw_sphere(Vec3d(0, 0.5, 0), sphere_camera(8));
  const Image background = draw_sphere(Vec3d(0, 100, 0), sphere_camera(8));
  int above = 0, below = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x)
      if (brightness(image, x, y) != brightness(background, x, y))
        ++(y < kSize.height / 2 ? above : below);
  EXPECT_GT(above, 2 * below);
  EXPECT_GT(below, 0);
}

TEST_F(RawPicture, AMovedMeshGivesAnotherPictureAndAnUnmovedOneTheSame) {
  const Camera camera = sphere_camera(5);
  const Image first = draw_sphere(Vec3d::Zero(), camera);
  const Image moved = draw_sphere(Vec3d(0.1, 0, 0), camera);
  const Image again = draw_sphere(Vec3d::Zero(), camera);
  EXPECT_GT(count_changed(first, moved), 1000);
  EXPECT_EQ(count_changed(first, again), 0);
}

TEST_F(RawPicture, DoesNotDependOnTheFilesUnitsOrOrigin) {
  TriangleMesh small = make_test_sphere(Vec3d::Zero(), 1), large = small;
  const Vec3d shift(4e6, -3e6, 1e6);
  for (Vec3d& vertex : large.vertices) vertex = 1000 * vertex + shift;
  Camera camera = sphere_camera(5);
  show(small);
  const Image near_picture = draw(camera);
  camera.target = shift;
  camera.distance *= 1000;
  camera.scene_radius *= 1000;
  show(large);
  const Image far_picture = draw(camera);
  for (size_t i = 0; i < near_picture.rgb.size(); ++i)
    ASSERT_NEAR(near_picture.rgb[i], far_picture.rgb[i], 3) << "byte " << i;
}

TEST_F(RawPicture, GroovesAreDarkerThanTheSameSurfaceWithoutItsRidges) {
  TriangleMesh groove = make_sheet(100, 1, -0.15);
  RawPages raw = make_raw_pages(groove);
  const Camera camera = frame_all({}, raw.box, kSize.aspect());
  patches_ = upload_pages(raw, *renderer_).value();
  const Image shaded = draw(camera);
  for (PageMesh& page : raw.pages) page.ridges.assign(page.ridges.size(), 0);
  patches_ = upload_pages(raw, *renderer_).value();
  const Image plain = draw(camera);
  EXPECT_LT(brightness(shaded, kSize.width / 2, kSize.height / 2),
            brightness(plain, kSize.width / 2, kSize.height / 2) - 10);
}

TEST_F(RawPicture, FlatAndWireframeStylesDiffer) {
  const Camera camera = sphere_camera(5);
  const Image smooth = draw_sphere(Vec3d::Zero(), camera);
  const Image flat = draw_sphere(Vec3d::Zero(), camera, {.flat = true});
  const Image wires = draw_sphere(Vec3d::Zero(), camera, {.wireframe = true});
  EXPECT_GT(count_changed(smooth, flat), 1000);
  EXPECT_GT(count_changed(smooth, wires), 1000);
  EXPECT_LT(brightness(wires, kSize.width / 2, kSize.height / 2 - 40),
            brightness(smooth, kSize.width / 2, kSize.height / 2 - 40));
}

TEST_F(RawPicture, AbsurdSizesAreRefusedAndTheNextPictureIsDrawn) {
  EXPECT_EQ(renderer_->draw({}, {15, 100}, {}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(renderer_->draw({}, {100, 8193}, {}, {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(renderer_->read_pixels().status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(draw(sphere_camera(5)).size, kSize);
}

TEST(EglContextTest, SaysWhatIsMissingWithoutADriver) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a new process, which loads EGL anew
  ASSERT_EQ(setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1), 0);
  EXPECT_EXIT(
      {
        unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");  // it would win
        const auto context = EglContext::create();
        std::fputs(context.status().message().c_str(), stderr);
        std::exit(context.is_ok() ? 0 : 1);
      },
      testing::ExitedWithCode(1), "no OpenGL context: .*libegl-mesa0");
  unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
}

}  // namespace
}  // namespace burnish
