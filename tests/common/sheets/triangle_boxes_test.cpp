#include "common/sheets/triangle_boxes.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using Corners = std::array<Vec3d, 3>;

/// Returns small triangles in a box of 100 a side.
std::vector<Corners> scattered_triangles(size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 95), part(0, 5);
  std::vector<Corners> triangles(count);
  for (Corners& corners : triangles) {
    const Vec3d first(place(random), place(random), place(random));
    for (Vec3d& corner : corners) corner = first + Vec3d(part(random), part(random), part(random));
  }
  return triangles;
}

Box3d box_of(const Corners& corners) {
  Box3d box;
  for (const Vec3d& corner : corners) box.extend(corner);
  return box;
}

TEST(TriangleBoxes, FindAllWhoseBoxesMeetInOrder) {
  const std::vector<Corners> triangles = scattered_triangles(3000);
  const TriangleBoxes boxes(triangles);
  for (const Box3d& box : {Box3d(Vec3d(10, 20, 30), Vec3d(15, 40, 32)),
                           Box3d(Vec3d(-50, -50, -50), Vec3d(1, 1, 200))}) {
    const std::vector<uint32_t> found = boxes.near(box);
    EXPECT_TRUE(std::ranges::is_sorted(found));
    EXPECT_LT(found.size(), triangles.size() / 4);
    for (uint32_t t = 0; t < triangles.size(); ++t) {
      if (!box.intersects(box_of(triangles[t]))) continue;
      EXPECT_TRUE(std::ranges::binary_search(found, t)) << t;
    }
  }
}

TEST(TriangleBoxes, BesideAllOfThemFindNone) {
  const TriangleBoxes boxes(scattered_triangles(100));
  EXPECT_TRUE(boxes.near({Vec3d(200, 0, 0), Vec3d(300, 100, 100)}).empty());
}

TEST(TriangleBoxes, OfNoTrianglesFindNone) {
  EXPECT_TRUE(TriangleBoxes({}).near({Vec3d::Zero(), Vec3d::Ones()}).empty());
}

TEST(TriangleBoxes, OfOneFlatTriangleFindIt) {
  const std::vector<Corners> one = {{Vec3d(0, 0, 5), Vec3d(9, 0, 5), Vec3d(0, 9, 5)}};
  EXPECT_THAT(TriangleBoxes(one).near({Vec3d::Zero(), Vec3d(9, 9, 9)}), testing::ElementsAre(0u));
}

}  // namespace
}  // namespace burnish
