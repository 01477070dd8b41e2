#include <gtest/gtest.h>

#include "tests/reference/awkward_meshes.h"
#include "tests/reference/curvature.h"
#include "tests/reference/reference.h"
#include "tests/reference/shapes.h"

namespace burnish::reference {
namespace {

double factorial(int n) {
  return n < 2 ? 1 : n * factorial(n - 1);
}

TEST(ReferenceQuadrature, IsExactForEveryMonomialUpToDegreeEight) {
  // Over the triangle x + y <= 1 the integral of x^p y^q is p! q! / (p + q + 2)!.
  const std::vector<QuadraturePoint> points = quadrature({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  for (int p = 0; p <= 8; ++p) {
    for (int q = 0; p + q <= 8; ++q) {
      double sum = 0;
      for (const QuadraturePoint& point : points)
        sum += point.weight * std::pow(point.position.x(), p) * std::pow(point.position.y(), q);
      EXPECT_NEAR(sum, factorial(p) * factorial(q) / factorial(p + q + 2), 1e-15) << p << ' ' << q;
    }
  }
}

TEST(ReferencePieces, FillTheTriangleAndStayInTheirCells) {
  const Polygon triangle = {{0.3, 0.2, 0.9}, {7.8, 3.3, 2.1}, {2.4, 9.6, 5.5}};
  double area = 0;
  cut_at_grid_planes(triangle, [&](const Lattice& cell, const Polygon& piece) {
    for (const QuadraturePoint& q : quadrature(piece)) area += q.weight;
    for (const Vec3d& p : piece) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(p[axis], cell[axis] - 1e-12);
        EXPECT_LE(p[axis], cell[axis] + 1 + 1e-12);
      }
    }
  });
  const double expected = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).norm() / 2;
  EXPECT_NEAR(area, expected, 1e-12 * expected);
}

TEST(ReferencePieces, OneInAGridPlaneGoesToTheCellAbove) {
  cut_at_grid_planes({{1.2, 3, 0.5}, {1.8, 3, 0.5}, {1.5, 3, 0.9}},
                     [](const Lattice& cell, const Polygon&) {
                       EXPECT_EQ(cell, (Lattice{1, 3, 0}));
                     });
  EXPECT_EQ(snapped({3 - 5e-8, 3 + 5e-8, 3 + 2e-7}), Vec3d(3, 3, 3 + 2e-7));
}

TEST(ReferenceIntegrals, HoldForEveryAwkwardMesh) {
  for (const auto& [name, mesh] : awkward_meshes()) {
    SCOPED_TRACE(name);
    const System system = build(mesh, 5);
    double rho = 0;
    for (const Cell& cell : system.cells) {
      const double size = cell.area;
      rho += cell.rho.sum();
      ASSERT_NEAR(cell.rho.sum(), size, 1e-12 * size);
      ASSERT_LT((cell.ell1 * Eigen::VectorXd::Ones(8)).norm(), 1e-13 * size);
      ASSERT_LT((cell.ell2 * Eigen::VectorXd::Ones(8)).norm(), 1e-13 * size);
      ASSERT_GE(cell.kappa1, cell.kappa2);
    }
    const double area = system.length_unit * system.length_unit;
    EXPECT_NEAR(rho * system.cell_size * system.cell_size, area, 1e-6 * area);
  }
}

TEST(ReferenceIntegrals, BothDirectionsTogetherAreTheGradientInTheTangentPlane) {
  // The tangential parts of grad x, y and z have squares that sum to 2, for any v1 and v2.
  const System system = build(bumpy_sphere(4), 5);
  for (const Cell& cell : system.cells) {
    Eigen::Matrix<double, 8, 3> local;
    for (int a = 0; a < 8; ++a) local.row(a) << (a & 1), ((a >> 1) & 1), (a >> 2);
    const double sum = (local.transpose() * (cell.ell1 + cell.ell2) * local).trace();
    EXPECT_NEAR(sum, 2 * cell.area, 1e-6 * cell.area);
  }
}

TEST(ReferenceIntegrals, FlatPartsFavourNoDirection) {
  const System system = build(bumped_sheet(30), 5);
  int flat_cells = 0;
  for (const Cell& cell : system.cells) {
    if (cell.kappa1 != 0 || cell.kappa2 != 0) continue;
    ++flat_cells;
    EXPECT_EQ((cell.ell1 - cell.ell2).norm(), 0);
  }
  EXPECT_GT(flat_cells, 100);
}

TEST(ReferenceEvaluation, OfTheCornersGivesTheVertices) {
  for (const auto& [name, mesh] : awkward_meshes()) {
    SCOPED_TRACE(name);
    const System system = build(mesh, 4);
    const Eigen::MatrixXd positions = evaluate(system, corner_positions(system));
    std::vector<bool> has_surface(mesh.vertices.size(), false);
    for (const Triangle& t : mesh.triangles)
      if (!is_degenerate(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]))
        for (uint32_t v : t) has_surface[v] = true;
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (!has_surface[v]) continue;
      ASSERT_GE(system.evaluation[v].cell, 0) << "vertex " << v;
      const Vec3d grid = (mesh.vertices[v] - system.origin) / system.cell_size;
      ASSERT_LT((positions.row(v).transpose() - grid).norm(), 2e-7) << "vertex " << v;
    }
  }
}

}  // namespace
}  // namespace burnish::reference
