#include "client/model/view/section_view.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

Ruler ruler_of(const Vec3d& first, const Vec3d& second) {
  Ruler ruler;
  ruler.put({first, first});
  ruler.put({second, second});
  return ruler;
}

/// Returns where the view shows a point of the plane.
Eigen::Vector2d shown(const Plane& plane, const SectionView& view, const Vec3d& point) {
  const PlaneAxes axes = axes_of(plane);
  const Vec3d way = point - plane.point;
  return view.place({axes.right.dot(way), axes.up.dot(way)});
}

TEST(SectionView, TheRulerLiesLevelAndHasLengthOne) {
  const Ruler ruler = ruler_of({1, 2, 3}, {4, 6, 3});
  const Plane plane = section_plane(ruler, Camera());
  EXPECT_NEAR(plane.height_of(ruler.ends()[1].edited), 0, 1e-12);
  const SectionView view(plane, ruler);
  EXPECT_LT((shown(plane, view, {1, 2, 3}) - Eigen::Vector2d(0, 0)).norm(), 1e-12);
  EXPECT_LT((shown(plane, view, {4, 6, 3}) - Eigen::Vector2d(1, 0)).norm(), 1e-12);
}

TEST(SectionView, ARulerAlongTheViewIsCutUpright) {
  const Camera camera;
  const Vec3d back = camera_axes(camera).row(2), up = camera_axes(camera).row(1);
  const Plane plane = section_plane(ruler_of(Vec3d::Zero(), back), camera);
  EXPECT_NEAR(std::abs(plane.normal.dot(up)), 0, 1e-12);
  EXPECT_NEAR(plane.normal.norm(), 1, 1e-12);
}

TEST(SectionView, MarksOfTheRulersWayAreRoundLengths) {
  const Ruler ruler = ruler_of({0, 0, 0}, {30, 40, 0});
  const SectionView view(section_plane(ruler, Camera()), ruler);
  const auto ticks = view.ticks(-0.05, 1.05, 0.15, "mm");
  ASSERT_EQ(ticks.size(), 6u);
  EXPECT_EQ(ticks[1].text, "10");
  EXPECT_NEAR(ticks[1].at, 0.2, 1e-12);
  EXPECT_EQ(ticks[5].text, "50 mm");
}

}  // namespace
}  // namespace burnish
