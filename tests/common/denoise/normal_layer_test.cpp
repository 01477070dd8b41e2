#include "common/denoise/normal_layer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "common/generate/generate.h"
#include "tests/common/denoise/shape_error.h"
#include "tests/common/split_vertices.h"

namespace burnish {
namespace {

/// All triangles look up.
ScratchArray<NormalAndArea> upward(const WeldedSurface& surface) {
  ScratchArray<NormalAndArea> normals = triangle_normals(surface);
  for (NormalAndArea& normal : normals) normal = NormalAndArea{0, 0, 1, normal[3]};
  return normals;
}

std::vector<Vec3f> layer(const TriangleMesh& mesh, const LayerOptions& options = {}) {
  const WeldedSurface surface(mesh);
  const auto normals = upward(surface);
  return normal_layer(surface, {normals.data(), normals.size()}, options);
}

TriangleMesh rough_sheet() {
  TriangleMesh sheet = make_sheet(30, 30, 0);
  for (size_t v = 0; v < sheet.vertices.size(); ++v)
    sheet.vertices[v].z() = v * v % 7 % 2 == 0 ? 0.2 : -0.2;
  return sheet;
}

double roughness(const TriangleMesh& mesh) {
  double mean = 0, squares = 0;
  const auto count = static_cast<double>(mesh.vertices.size());
  for (const Vec3d& p : mesh.vertices) mean += p.z() / count;
  for (const Vec3d& p : mesh.vertices) squares += (p.z() - mean) * (p.z() - mean) / count;
  return std::sqrt(squares);
}

TEST(NormalLayer, OfAFlatSurfaceIsNothing) {
  for (const Vec3f& move : layer(make_sheet(10, 5, 0))) EXPECT_LT(move.norm(), 1e-12);
}

TEST(NormalLayer, MovesVerticesUntilTrianglesHaveTheNormals) {
  const TriangleMesh sheet = rough_sheet();
  const std::vector<Vec3f> moves = layer(sheet);
  for (const Vec3f& move : moves) EXPECT_EQ(move.head<2>(), Eigen::Vector2f(0, 0));
  EXPECT_LT(roughness(moved(sheet, moves)), 0.3 * roughness(sheet));
}

TEST(NormalLayer, IsNearerToTheNormalsWithMoreUpdates) {
  const TriangleMesh sheet = rough_sheet();
  double before = roughness(sheet);
  for (const int updates : {1, 5, 20}) {
    const double after = roughness(moved(sheet, layer(sheet, {.updates = updates})));
    EXPECT_LT(after, 0.9 * before) << updates;
    before = after;
  }
}

TEST(NormalLayer, MovesNoVertexFurtherThanTheCap) {
  double longest = 0;
  for (const Vec3f& move : layer(rough_sheet(), {.cap = 0.05}))
    longest = std::max<double>(longest, move.norm());
  EXPECT_NEAR(longest, 0.05, 1e-6);
  for (const Vec3f& move : layer(rough_sheet(), {.cap = 0})) EXPECT_EQ(move, Vec3f(0, 0, 0));
}

TEST(NormalLayer, VerticesAtOnePlaceMoveAlike) {
  const TriangleMesh sheet = rough_sheet(), soup = as_soup(sheet);
  const std::vector<Vec3f> joined = layer(sheet), split = layer(soup);
  for (size_t t = 0; t < sheet.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      ASSERT_EQ(split[soup.triangles[t][corner]], joined[sheet.triangles[t][corner]]);
}

TEST(NormalLayer, AVertexWithoutATriangleStays) {
  TriangleMesh sheet = rough_sheet();
  sheet.vertices.emplace_back(1, 2, 3);
  EXPECT_EQ(layer(sheet).back(), Vec3f(0, 0, 0));
}

TEST(NormalLayer, TrianglesThatWouldTurnKeepTheirCorners) {
  TriangleMesh mesh;  // the second triangle pulls the flat one's tip over its base
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 0.02, 0}, {0.2, -2, 0}, {0.8, -2, 0}};
  mesh.triangles = {{0, 1, 2}, {2, 3, 4}};
  const WeldedSurface surface(mesh);
  auto normals = triangle_normals(surface);
  normals[1] = NormalAndArea{0, 0.8f, 0.6f, normals[1][3]};
  const std::vector<Vec3f> moves = normal_layer(surface, {normals.data(), normals.size()});
  EXPECT_EQ(moves[2], Vec3f(0, 0, 0));
  EXPECT_GT(moves[3].y(), 0.4);
  EXPECT_EQ(turned_share(mesh, moved(mesh, moves)), 0);
}

TEST(NormalLayer, HasTheSameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = *generate_scan({"blob", 5000});
  const WeldedSurface surface(mesh);
  const auto normals = upward(surface);
  const int before = thread_count();
  use_threads(1);
  const auto expected = normal_layer(surface, {normals.data(), normals.size()});
  for (const int threads : {2, 3}) {
    use_threads(threads);
    EXPECT_EQ(normal_layer(surface, {normals.data(), normals.size()}), expected);
  }
  use_threads(before);
}

TEST(NormalLayer, HearsACancel) {
  const TriangleMesh mesh = rough_sheet();
  const WeldedSurface surface(mesh);
  const auto normals = upward(surface);
  const Progress cancel = [](std::string_view, double) { return false; };
  EXPECT_THROW(normal_layer(surface, {normals.data(), normals.size()}, {}, {}, {cancel, "layer"}),
               WorkCancelled);
}

}  // namespace
}  // namespace burnish
