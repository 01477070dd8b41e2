#include <gtest/gtest.h>

#include "common/mesh/statistics/statistics.h"
#include "tests/common/split_vertices.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

/// Returns the largest distance at the corners of the triangles, over the diagonal.
double difference(const TriangleMesh& a, const TriangleMesh& b) {
  double most = 0;
  for (size_t t = 0; t < a.triangles.size(); ++t)
    for (int side = 0; side < 3; ++side)
      most = std::max(most,
                      (a.vertices[a.triangles[t][side]] - b.vertices[b.triangles[t][side]]).norm());
  return most / compute_statistics(a).diagonal();
}

class Seams : public testing::TestWithParam<Controls> {
 protected:
  static TriangleMesh filtered(const TriangleMesh& mesh) {
    const SetTransferCurve curve{*TransferCurve::parse("-40:200,-10:2,10:2,40:200")};
    return exact_surface(*session_over(mesh, 5, GetParam()), {curve, SetGradientScale{0}});
  }
};

TEST_P(Seams, AClosedSurfaceMovesAlikeHoweverItsTrianglesShareVertices) {
  const TriangleMesh blob = lumpy_scan();
  const TriangleMesh joined = filtered(blob);
  EXPECT_GT(difference(joined, blob), 1e-2);
  EXPECT_LT(difference(filtered(as_soup(blob)), joined), 1e-6);
  EXPECT_LT(difference(filtered(with_seam(blob)), joined), 1e-6);
}

TEST_P(Seams, AnOpenSurfaceToo) {
  TriangleMesh dome = lumpy_scan();
  std::erase_if(dome.triangles, [&](const Triangle& t) { return dome.vertices[t[0]].z() < -0.2; });
  const TriangleMesh joined = filtered(dome);
  EXPECT_LT(difference(filtered(as_soup(dome)), joined), 1e-6);
  EXPECT_LT(difference(filtered(with_seam(dome)), joined), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(All, Seams, testing::Values(Controls{}, Controls{.pin_rims = true}));

}  // namespace
}  // namespace burnish
