#include "client/pages/page_view.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr ImageSize kSize = {1600, 900};

Camera far_from_the_origin() {
  Camera camera;
  camera.target = Vec3d(4.5e5, 5.2e6, 120);  // as surveys have it
  camera.distance = 8;
  camera.azimuth_degrees = 30;
  camera.elevation_degrees = 20;
  camera.zoom = 3;
  camera.scene_radius = 5;
  return camera;
}

PageGrid grid_at(const Camera& camera) {
  PageGrid grid;
  grid.origin = camera.target - Vec3d(2, 2, 2);
  grid.side = 4;
  return grid;
}

PageBounds sphere(const Vec3d& centre, const PageGrid& grid, float radius) {
  PageBounds bounds;
  bounds.centre = (centre - grid.origin).cast<float>();
  bounds.radius = radius;
  return bounds;
}

TEST(PageView, ALengthAtTheTargetMeasuresAsManyPixelsAsInThePicture) {
  const Camera camera = far_from_the_origin();
  const PageView view = make_page_view(camera, kSize, grid_at(camera));
  const double pixels = view.pixels_at_one / camera.distance;
  EXPECT_NEAR(pixels, 1 / pixel_length(camera, kSize), 1e-3 * pixels);
}

TEST(PageView, WithoutPerspectiveALengthMeasuresTheSameAnywhere) {
  Camera camera = far_from_the_origin();
  camera.orthographic = true;
  const PageGrid grid = grid_at(camera);
  const PageView view = make_page_view(camera, kSize, grid);
  const Vec3d back = camera_axes(camera).row(2);
  for (const double depth : {-3.0, 0.0, 3.0}) {
    const PageBounds bounds = sphere(camera.target + depth * back, grid, 0.5f);
    const double pixels = view.pixels_at_one / distance_to(view, bounds, 0);
    EXPECT_NEAR(pixels, 1 / pixel_length(camera, kSize), 1e-3 * pixels);
    EXPECT_TRUE(is_inside(view, bounds, 0)) << depth;
  }
  const Vec3d right = camera_axes(camera).row(0);
  EXPECT_FALSE(is_visible(view, sphere(camera.target + 9 * right, grid, 0.5f), 0));
}

TEST(PageView, TheEyeIsRelativeToTheGrid) {
  const Camera camera = far_from_the_origin();
  const PageGrid grid = grid_at(camera);
  const PageView view = make_page_view(camera, kSize, grid);
  const PageBounds target = sphere(camera.target, grid, 0.5f);
  EXPECT_NEAR(distance_to(view, target, 0), 7.5, 1e-5);
  EXPECT_NEAR(distance_to(view, target, 0.25f), 7.25, 1e-5);
}

TEST(PageView, NothingIsNearerThanTheDepthRange) {
  const Camera camera = far_from_the_origin();
  const PageView view = make_page_view(camera, kSize, grid_at(camera));
  EXPECT_NEAR(view.nearest, 3, 1e-4);
  EXPECT_NEAR(distance_to(view, sphere(camera.target, grid_at(camera), 20), 0), 3, 1e-4);
}

TEST(PageView, SpheresAreVisibleIfTheyReachIntoThePicture) {
  const Camera camera = far_from_the_origin();
  const PageGrid grid = grid_at(camera);
  const PageView view = make_page_view(camera, kSize, grid);
  const Vec3d right = camera_axes(camera).row(0).transpose();
  const Ray ray = pixel_ray(camera, kSize, {1600, 450});  // the middle of the right edge
  const Vec3d at_edge = ray.origin + 8 * ray.direction;
  EXPECT_TRUE(is_visible(view, sphere(at_edge - 0.02 * right, grid, 0.01f), 0));
  EXPECT_TRUE(is_inside(view, sphere(at_edge - 0.02 * right, grid, 0.01f), 0));
  EXPECT_TRUE(is_visible(view, sphere(at_edge, grid, 0.01f), 0));
  EXPECT_FALSE(is_inside(view, sphere(at_edge, grid, 0.01f), 0));
  EXPECT_FALSE(is_visible(view, sphere(at_edge + 0.02 * right, grid, 0.01f), 0));
  EXPECT_TRUE(is_visible(view, sphere(at_edge + 0.02 * right, grid, 0.01f), 0.02f)) << "it moves";
}

TEST(PageView, NothingBehindTheEyeIsVisible) {
  const Camera camera = far_from_the_origin();
  const PageGrid grid = grid_at(camera);
  const PageView view = make_page_view(camera, kSize, grid);
  const Vec3d back = camera_axes(camera).row(2).transpose();
  EXPECT_FALSE(is_visible(view, sphere(camera.target + 10 * back, grid, 1), 0));
}

}  // namespace
}  // namespace burnish
