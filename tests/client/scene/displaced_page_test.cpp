#include "client/scene/displaced_page.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "tests/client/scene/page_splitter.h"

namespace burnish {
namespace {

constexpr int kDepth = 5;

class PointOnPage : public testing::Test {
 protected:
  const SplitMesh split_ = split_into_pages(make_icosphere(3, 2), 400);
  const PageSpace space_ = make_page_space(split_.grid, kDepth);
};

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
