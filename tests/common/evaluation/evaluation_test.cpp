#include "common/evaluation/evaluation.h"

#include <random>

#include <gtest/gtest.h>

#include "tests/reference/awkward_meshes.h"
#include "tests/reference/curvature.h"
#include "tests/reference/reference.h"

namespace burnish {
namespace {

struct Sample {
  GridFrame frame;
  SparseGrid grid;
  std::vector<EvaluationPoint> rows;
};

// Takes the active cells from the reference's cutting.
Sample sample_of(const TriangleMesh& mesh, int depth) {
  const reference::System system = reference::build(mesh, depth);
  std::vector<MortonKey> cells;
  for (const reference::Cell& cell : system.cells)
    cells.push_back(morton_key({cell.key[0], cell.key[1], cell.key[2]}));
  std::sort(cells.begin(), cells.end());
  Sample sample{{system.origin, system.cell_size, depth}, make_finest_grid(depth, cells), {}};
  sample.rows.resize(mesh.vertices.size());
  make_evaluation(mesh, sample.frame, cells, sample.rows);
  return sample;
}

std::vector<bool> vertices_with_surface(const TriangleMesh& mesh) {
  std::vector<bool> has_surface(mesh.vertices.size(), false);
  for (const auto& [a, b, c] : mesh.triangles)
    if (!reference::is_degenerate(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]))
      has_surface[a] = has_surface[b] = has_surface[c] = true;
  return has_surface;
}

void expect_positions_reproduced(const TriangleMesh& mesh, int depth) {
  const Sample sample = sample_of(mesh, depth);
  const double side = sample.frame.cells_per_side();
  const Vec3d centre =
      Vec3d::Constant(side / 2);  // rounding of the float weights grows with distance
  std::vector<Vec3d> corners;
  for (const GridKey& corner : sample.grid.corners)
    corners.push_back(morton_point(corner.place).cast<double>() - centre);
  const std::vector<bool> has_surface = vertices_with_surface(mesh);
  for (size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (!has_surface[v]) continue;
    ASSERT_NE(sample.rows[v].cell, kNone) << "vertex " << v;
    const Vec3d position = centre + evaluate<Vec3d>(sample.grid, sample.rows[v], corners);
    const Vec3d expected = sample.frame.to_grid(mesh.vertices[v]);
    ASSERT_LT((position - expected).norm(), 1e-7 * side) << "vertex " << v;
  }
}

TEST(Evaluation, OfTheCornersGivesTheVertices) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    expect_positions_reproduced(mesh, 5);
  }
}

TEST(Evaluation, FindsVerticesOnGridPlanesOfFlatFaces) {
  for (int depth : {4, 5, 6}) expect_positions_reproduced(reference::stepped_block(2), depth);
}

TEST(Evaluation, LeavesUnreferencedVerticesOut) {
  const TriangleMesh mesh = reference::sphere_with_debris(3);
  const Sample sample = sample_of(mesh, 5);
  EXPECT_EQ(sample.rows[3].cell, kNone);
  EXPECT_EQ(sample.rows.back().cell, kNone);
  const std::vector<Vec3d> displacement(sample.grid.corners.size(), Vec3d::Ones());
  EXPECT_EQ(evaluate<Vec3d>(sample.grid, sample.rows[3], displacement), Vec3d::Zero());
}

TEST(Evaluation, TakesTheCellBelowWhereNoneLiesAbove) {
  const TriangleMesh mesh = {{{0, 0, 0}, {0.9, 0, 0}, {0, 0.9, 0}}, {{0, 1, 2}}};
  const GridFrame frame{Vec3d(-1, -1, -1), 1, 4};  // every vertex in planes y or z
  const std::vector<MortonKey> below = {morton_key({1, 1, 0})};
  std::vector<EvaluationPoint> points(mesh.vertices.size());
  make_evaluation(mesh, frame, below, points);
  for (const EvaluationPoint& point : points) {
    EXPECT_EQ(point.cell, 0);
    EXPECT_EQ(point.local[2], 1);
  }
}

TEST(TrilinearWeights, SumToOneAndReproduceTheLocalPosition) {
  std::mt19937 random(5);
  const auto next = [&] { return static_cast<float>(random() % 1025) / 1024; };
  for (int i = 0; i < 1000; ++i) {
    const std::array<float, 3> local = {next(), next(), next()};
    const auto weights = trilinear_weights(local);
    double sum = 0;
    Vec3d position = Vec3d::Zero();
    for (int a = 0; a < kCornersPerCell; ++a) {
      ASSERT_GE(weights[a], 0);
      sum += weights[a];
      position += weights[a] * corner_offset(a).cast<double>();
    }
    ASSERT_NEAR(sum, 1, 2e-7);
    for (int axis = 0; axis < 3; ++axis) ASSERT_NEAR(position[axis], local[axis], 2e-7);
  }
}

TEST(TrilinearWeights, AreOneAtTheirOwnCorner) {
  for (int a = 0; a < kCornersPerCell; ++a) {
    const Vec3i at = corner_offset(a);
    const auto weights = trilinear_weights(
        {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())});
    for (int b = 0; b < kCornersPerCell; ++b) EXPECT_EQ(weights[b], a == b ? 1 : 0);
  }
}

}  // namespace
}  // namespace burnish
