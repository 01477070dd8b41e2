#include "server/fields/target_fit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "server/prepare/prepare.h"
#include "tests/reference/shapes.h"

namespace burnish {
namespace {

using Mat3d = Eigen::Matrix3d;

std::shared_ptr<const PreparedMesh> prepared_at_depth_4(const TriangleMesh& mesh) {
  auto prepared = prepare(mesh, {.depth = 4});
  EXPECT_TRUE(prepared.is_ok()) << prepared.status().message();
  return *prepared;
}

Mat3d matrix_of(const std::array<float, 9>& rows) {
  return Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(rows.data()).cast<double>();
}

std::vector<Vec3f> normals_of(const PreparedMesh& prepared) {
  std::vector<Vec3f> normals;
  for (const Triangle& t : prepared.triangles) {
    const Vec3d first = prepared.vertices[t[0]];
    normals.push_back((prepared.vertices[t[1]] - first)
                          .cross(prepared.vertices[t[2]] - first)
                          .normalized()
                          .cast<float>());
  }
  return normals;
}

/// A tilted flat square, the same normals for all its triangles, and a linear layer.
struct TiltedSquare {
  TiltedSquare()
      : tangents{Vec3d(1, 0, 0.3).normalized(), Vec3d(0, 1, 0.2)},
        prepared(prepared_at_depth_4(reference::grid_surface(
            12, 12, false,
            [this](double u, double v) -> Vec3d { return u * tangents[0] + v * tangents[1]; }))),
        normals(prepared->triangles.size(),
                Eigen::AngleAxisf(0.3F, tangents[0].cast<float>()) * normals_of(*prepared)[0]),
        layer(prepared->vertices.size(), Vec3f::Zero()) {}

  /// ∇x is the projection on the square, so the matrices must do this to its tangents.
  void expect_matrices(const SurfaceTarget& target, const Mat3d& of_scale, const Mat3d& of_target) {
    const auto cells = fit_target(*prepared, target);
    ASSERT_TRUE(cells.is_ok()) << cells.status().message();
    ASSERT_EQ(cells->size(), prepared->cells.size());
    for (const TargetGradient& cell : *cells)
      for (const Vec3d& tangent : tangents) {
        EXPECT_LT((matrix_of(cell.of_scale) * tangent - of_scale * tangent).norm(), 2e-3);
        EXPECT_LT((matrix_of(cell.of_target) * tangent - of_target * tangent).norm(), 2e-3);
      }
  }

  std::array<Vec3d, 2> tangents;
  std::shared_ptr<const PreparedMesh> prepared;
  std::vector<Vec3f> normals, layer;
};

TEST(TargetFit, NormalsOfTheSurfaceItselfLeaveNothingToDo) {
  const auto prepared = prepared_at_depth_4(reference::bumpy_sphere(3));
  const std::vector<Vec3f> normals = normals_of(*prepared);
  const std::vector<Vec3f> layer(prepared->vertices.size(), Vec3f::Zero());
  const auto cells = fit_target(*prepared, {normals, layer, 1});
  ASSERT_TRUE(cells.is_ok());
  for (const TargetGradient& cell : *cells) {
    EXPECT_LT(matrix_of(cell.of_scale).norm(), 1e-5);
    EXPECT_LT(matrix_of(cell.of_target).norm(), 1e-5);
  }
}

TEST(TargetFit, TiltedNormalsTakeTheGradientAlongThem) {
  TiltedSquare square;
  const Vec3d wanted = square.normals[0].cast<double>();
  const Mat3d left = -wanted * wanted.transpose();
  square.expect_matrices({square.normals, square.layer, 1}, left, left);
}

TEST(TargetFit, ALayerCountsByItsCrispness) {
  TiltedSquare square;
  const Mat3d slope = (Mat3d() << 0, 0, 0, 0, 0, 0, 0.2, -0.1, 0).finished();
  for (size_t v = 0; v < square.layer.size(); ++v)
    square.layer[v] = (slope * square.prepared->vertices[v]).cast<float>();
  const Vec3d wanted = square.normals[0].cast<double>();
  for (const double crispness : {0.0, 0.5, 1.0}) {
    const Mat3d layer = crispness * slope;
    const Mat3d left = -wanted * wanted.transpose() * (Mat3d::Identity() + layer);
    square.expect_matrices({square.normals, square.layer, crispness}, layer + left, left);
  }
}

// Few cells have one side alone.
TEST(TargetFit, TwoSidesOfAWallInACellHaveNoTarget) {
  TriangleMesh wall = reference::grid_surface(12, 12, false, [](double u, double v) -> Vec3d {
    return {u, v, 0.3 * u + 0.2 * v};
  });
  const TriangleMesh front = wall;
  const auto vertices = static_cast<uint32_t>(front.vertices.size());
  for (const Vec3d& p : front.vertices) wall.vertices.emplace_back(p + Vec3d(0, 0, 1e-3));
  for (const Triangle& t : front.triangles)
    wall.triangles.push_back({t[1] + vertices, t[0] + vertices, t[2] + vertices});
  const auto prepared = prepared_at_depth_4(wall);
  std::vector<Vec3f> normals = normals_of(*prepared);
  for (Vec3f& normal : normals) normal = (normal + Vec3f(0.2F, 0, 0)).normalized();
  const std::vector<Vec3f> layer(prepared->vertices.size(), Vec3f::Zero());
  const auto cells = fit_target(*prepared, {normals, layer, 1});
  ASSERT_TRUE(cells.is_ok());
  const auto without = std::ranges::count_if(
      *cells, [](const TargetGradient& cell) { return cell.of_target == std::array<float, 9>{}; });
  EXPECT_GT(without, 0.8 * static_cast<double>(cells->size()));
}

TEST(TargetFit, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = reference::bumpy_sphere(4);
  const auto prepared = prepared_at_depth_4(mesh);
  std::vector<Vec3f> normals = normals_of(*prepared);
  for (size_t t = 0; t < normals.size(); t += 3) normals[t] = normals[t / 2];
  const std::vector<Vec3f> layer(prepared->vertices.size(), Vec3f(0.01F, 0, 0));
  const auto fitted = [&](int threads) {
    use_threads(threads);
    return *fit_target(*prepared, {normals, layer, 0.5});
  };
  const auto one = fitted(1), three = fitted(3);
  use_threads(0);
  ASSERT_EQ(one.size(), three.size());
  for (size_t c = 0; c < one.size(); ++c) {
    EXPECT_EQ(one[c].of_scale, three[c].of_scale);
    EXPECT_EQ(one[c].of_target, three[c].of_target);
  }
}

TEST(TargetFit, HearsACancel) {
  const auto prepared = prepared_at_depth_4(reference::bumpy_sphere(3));
  const std::vector<Vec3f> normals = normals_of(*prepared);
  const std::vector<Vec3f> layer(prepared->vertices.size(), Vec3f::Zero());
  const auto fitted =
      fit_target(*prepared, {normals, layer, 1}, [](std::string_view, double) { return false; });
  EXPECT_EQ(fitted.status().code(), StatusCode::kCancelled);
}

}  // namespace
}  // namespace burnish
