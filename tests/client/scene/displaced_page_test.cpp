#include "client/scene/displaced_page.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"
#include "tests/client/scene/random_moves.h"

namespace burnish {
namespace {

constexpr int kDepth = 5;

class PointOnPage : public testing::Test {
 protected:
  const SplitMesh split_ = split_into_pages(make_icosphere(3, 2), 400);
  const PageSpace space_ = make_page_space(split_.grid, kDepth);
};

TEST_F(PointOnPage, ARayThroughATriangleMeetsItsDisplacedAndItsOriginalPoint) {
  const Page& page = split_.pages.at(1);
  const PageMesh mesh = make_page_mesh(page, split_.grid);
  const std::vector<Vec3f> moves = random_moves(page.positions, 3);
  const double cell = split_.grid.side / (1 << kDepth);
  const Vec3d weights(0.2, 0.3, 0.5);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Vec3d original = Vec3d::Zero(), displaced = Vec3d::Zero();
    for (int i = 0; i < 3; ++i) {
      const uint16_t v = mesh.triangles[t][i];
      original += weights[i] * split_.grid.to_file(page.positions[v]);
      displaced +=
          weights[i] * (split_.grid.to_file(page.positions[v]) + cell * moves[v].cast<double>());
    }
    const Vec3d eye(7, 9, -8);
    const Ray ray{eye, (displaced - eye).normalized()};
    const auto hit = point_on_page_triangle({mesh, space_, moves}, ray, t);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, t);
    EXPECT_LT((hit->displaced - displaced).norm(), 1e-9);
    EXPECT_LT((hit->original - original).norm(), 1e-9);
    EXPECT_NEAR(hit->distance, (displaced - eye).norm(), 1e-9);
  }
}

TEST_F(PointOnPage, ARayBesideTheTriangleGivesThePointNextToItAndOneAwayGivesNone) {
  const PageMesh mesh = make_page_mesh(split_.pages.at(0), split_.grid);
  const Vec3d corner = space_.to_file(mesh.positions[mesh.triangles[0][0]]);
  const Vec3d eye = 3 * corner;
  const Ray beside{eye, (corner + Vec3d::Constant(1e-6) - eye).normalized()};
  const auto hit = point_on_page_triangle({mesh, space_, {}}, beside, 0);
  ASSERT_TRUE(hit.has_value());
  EXPECT_GE(hit->weights.minCoeff(), 0);
  EXPECT_LT((hit->original - corner).norm(), 1e-5);
  EXPECT_EQ(hit->original, hit->displaced);
  EXPECT_FALSE(point_on_page_triangle({mesh, space_, {}}, Ray{eye, corner.normalized()}, 0));
}

TEST_F(PointOnPage, TheNearestOfAllPagesIsTheNearestOfTheMesh) {
  for (int i = 0; i < 20; ++i) {
    const Vec3d eye(5, 0.3 * i - 3, 0.1 * i);
    const Ray ray{eye, (Vec3d(0.1, 0.05 * i, 0.3) - eye).normalized()};
    double expected = 1e9;
    for (const auto& [a, b, c] : split_.rounded.triangles) {
      const auto& at = split_.rounded.vertices;
      const auto plane = hit_plane({at[a], at[b], at[c]}, ray);
      if (plane && is_inside(*plane)) expected = std::min(expected, plane->distance);
    }
    ASSERT_LT(expected, 1e9);
    double nearest = 1e9;
    for (const Page& page : split_.pages) {
      const PageMesh mesh = make_page_mesh(page, split_.grid);
      const auto hit = nearest_hit({mesh, space_, {}}, ray, 0, mesh.triangles.size());
      if (hit) nearest = std::min(nearest, hit->distance);
    }
    EXPECT_NEAR(nearest, expected, 1e-5);
  }
}

}  // namespace
}  // namespace burnish
