#include "common/evaluation/proxy.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"

namespace burnish {
namespace {

// Returns evaluation points that tell vertices apart; a grid is not needed here.
std::vector<EvaluationPoint> numbered_points(size_t count) {
  std::vector<EvaluationPoint> points(count);
  for (size_t v = 0; v < count; ++v) points[v].cell = static_cast<int32_t>(v);
  return points;
}

Proxy proxy_of(const TriangleMesh& mesh, size_t triangles_max) {
  const auto points = numbered_points(mesh.vertices.size());
  return make_proxy({mesh.vertices, mesh.triangles, points}, triangles_max);
}

class ProxyOf : public testing::TestWithParam<const char*> {
 protected:
  TriangleMesh mesh_ = generate_scan({.kind = GetParam(), .vertices = 20000}).value();
};

TEST_P(ProxyOf, HasAtMostTheTrianglesAskedFor) {
  for (const size_t triangles_max : {10000, 1000, 100}) {
    const Proxy proxy = proxy_of(mesh_, triangles_max);
    EXPECT_LE(proxy.triangles.size(), triangles_max);
    EXPECT_GT(proxy.triangles.size(), triangles_max / 10);
  }
}

TEST_P(ProxyOf, IsMadeOfTheScansVerticesAndTheirEvaluationPoints) {
  const Proxy proxy = proxy_of(mesh_, 3000);
  ASSERT_EQ(proxy.source.size(), proxy.evaluation.size());
  std::vector<bool> used(proxy.source.size(), false);
  for (const Triangle& triangle : proxy.triangles)
    for (const uint32_t vertex : triangle) used.at(vertex) = true;
  for (size_t v = 0; v < proxy.source.size(); ++v) {
    EXPECT_TRUE(used[v]);
    EXPECT_EQ(proxy.evaluation[v].cell, static_cast<int32_t>(proxy.source[v]));
  }
}

INSTANTIATE_TEST_SUITE_P(Scans, ProxyOf, testing::Values("blob", "tablet", "soup", "fan"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Proxy, OfASmallScanIsAllOfIt) {
  const TriangleMesh mesh = make_icosphere(2, 1);
  const Proxy proxy = proxy_of(mesh, mesh.triangles.size());
  EXPECT_EQ(proxy.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(proxy.source.size(), mesh.vertices.size());
}

TEST(Proxy, StaysOnTheSphere) {
  const TriangleMesh mesh = make_icosphere(6, 1);
  const Proxy proxy = proxy_of(mesh, 2000);
  for (const auto& [a, b, c] : proxy.triangles) {
    const Vec3d centre = (mesh.vertices[proxy.source[a]] + mesh.vertices[proxy.source[b]] +
                          mesh.vertices[proxy.source[c]]) /
                         3;
    EXPECT_NEAR(centre.norm(), 1, 0.01);
  }
}

TEST(Proxy, FarFromTheOriginItIsTheSame) {
  TriangleMesh mesh = make_icosphere(5, 1);
  const Proxy near = proxy_of(mesh, 1000);
  for (Vec3d& vertex : mesh.vertices) vertex += Vec3d(4e6, -5e6, 1e6);
  EXPECT_NEAR(static_cast<double>(proxy_of(mesh, 1000).source.size()),
              static_cast<double>(near.source.size()), 20);
}

TEST(Proxy, VerticesWithoutTrianglesAreLeftOut) {
  TriangleMesh mesh = make_icosphere(2, 1);
  mesh.vertices.insert(mesh.vertices.begin(), Vec3d(0, 0, 0));
  for (Triangle& triangle : mesh.triangles)
    for (uint32_t& vertex : triangle) ++vertex;
  const Proxy proxy = proxy_of(mesh, 1000);
  EXPECT_EQ(std::ranges::count(proxy.source, 0u), 0);
  EXPECT_EQ(proxy.source.size(), mesh.vertices.size() - 1);
}

TEST(RoundedTrianglesMax, HasTwoBitsAndIsNoLessThanAThousand) {
  EXPECT_EQ(rounded_triangles_max(0), 0u);
  EXPECT_EQ(rounded_triangles_max(1), 1000u);
  EXPECT_EQ(rounded_triangles_max(1535), 1024u);
  EXPECT_EQ(rounded_triangles_max(1536), 1536u);
  EXPECT_EQ(rounded_triangles_max(100'000), 98'304u);
  EXPECT_EQ(rounded_triangles_max(100'059), 98'304u);
  EXPECT_EQ(rounded_triangles_max(UINT64_MAX), uint64_t{3} << 62);
}

}  // namespace
}  // namespace burnish
