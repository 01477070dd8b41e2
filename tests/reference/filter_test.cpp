#include <gtest/gtest.h>

#include "tests/reference/awkward_meshes.h"
#include "tests/reference/compare.h"
#include "tests/reference/reference.h"
#include "tests/reference/shapes.h"

namespace burnish::reference {
namespace {

/// (a^2 + beta l^2) / (a^2 + l^2) of section 3.2, with alpha in user units.
double transfer(const System& system, double alpha, double beta, double lambda_squared) {
  const double a2 = std::pow(alpha / system.length_unit, 2);
  return (a2 + beta * lambda_squared) / (a2 + lambda_squared);
}

TEST(ReferenceFilter, GradientScaleOneReturnsTheInputExactly) {
  for (const auto& [name, mesh] : awkward_meshes()) {
    SCOPED_TRACE(name);
    const System system = build(mesh, 4);
    EXPECT_EQ(edited_vertices(system, fields(system, TransferCurve(7), 1)), mesh.vertices);
  }
}

TEST(ReferenceFilter, SphereShrinksAndGrowsByTheTransferFunctionAtEveryDepth) {
  const double radius = 3;
  const TriangleMesh mesh =
      mapped(icosphere(5, radius), [](const Vec3d& p) { return Vec3d(p + Vec3d(0.1, 0.2, 0.3)); });
  for (int depth : {3, 4, 6}) {
    const System system = build(mesh, depth);
    for (double beta : {0., 2.}) {
      const double h = transfer(system, 5, beta, 2 / (radius * radius));
      const std::vector<Vec3d> edited =
          edited_vertices(system, fields(system, TransferCurve(5), beta));
      for (size_t v = 0; v < edited.size(); ++v) {
        const Vec3d centre(0.1, 0.2, 0.3);
        ASSERT_LT((edited[v] - centre - h * (mesh.vertices[v] - centre)).norm(), 1e-3 * radius)
            << "depth " << depth << ", beta " << beta << ", vertex " << v;
      }
    }
  }
}

using Harmonic = double (*)(const Vec3d&);

/// Returns the root mean square over the vertices of the filtered harmonic less H times it, beta =
/// 0.
double harmonic_error(const TriangleMesh& sphere, int depth, int order, Harmonic f) {
  const System system = build(sphere, depth);
  Eigen::MatrixXd signal = corner_positions(system);
  for (auto row : signal.rowwise())
    row[0] = f(system.origin + system.cell_size * Vec3d(row.transpose()));
  signal.conservativeResize(Eigen::NoChange, 1);
  const Solution solution = solve(system, fields(system, TransferCurve(10), 0), signal);
  const Eigen::MatrixXd filtered = evaluate(system, signal + solution.displacement);
  const double h = transfer(system, 10, 0, order * (order + 1));
  double sum = 0;
  for (size_t v = 0; v < sphere.vertices.size(); ++v)
    sum += std::pow(filtered(v) - h * f(sphere.vertices[v]), 2);
  return std::sqrt(sum / sphere.vertices.size());
}

TEST(ReferenceFilter, HarmonicsOfTheTrialSpaceAreScaledToTheMeshsError) {
  const TriangleMesh sphere = icosphere(6, 1);
  EXPECT_LT(harmonic_error(sphere, 5, 2, [](const Vec3d& p) { return p.x() * p.y(); }), 4e-5);
  EXPECT_LT(harmonic_error(sphere, 5, 3, [](const Vec3d& p) { return p.x() * p.y() * p.z(); }),
            1e-5);
}

TEST(ReferenceFilter, HarmonicOutsideTheTrialSpaceConvergesWithOrderTwo) {
  const TriangleMesh sphere = icosphere(6, 1);
  const Harmonic zonal = [](const Vec3d& p) { return 3 * p.z() * p.z() - 1; };
  const double coarse = harmonic_error(sphere, 4, 2, zonal);
  const double fine = harmonic_error(sphere, 5, 2, zonal);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
  EXPECT_LT(std::log2(coarse / fine), 2.2);
}

TEST(ReferenceFilter, OpenCylinderFollowsItsTwoClosedFormsAlignedAndTurned) {
  const double radius = 1, height = 2.5, around = 20, along = 4;  // the alphas, user units
  const TriangleMesh upright = open_cylinder(200, 160, radius, height);
  for (const Eigen::Matrix3d& turn : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), skew_turn()}) {
    const System system =
        build(mapped(upright, [&](const Vec3d& p) { return Vec3d(turn * p); }), 5);
    for (double beta : {0., 2.}) {
      const double kappa = system.length_unit / radius;
      const TransferCurve curve =
          TransferCurve::create({{0.25 * kappa, along}, {0.75 * kappa, around}}).value();
      const std::vector<Vec3d> edited = edited_vertices(system, fields(system, curve, beta));
      const double a2 = along / system.length_unit;
      const double across = transfer(system, around, beta, 1 / (radius * radius));
      for (size_t v = 0; v < edited.size(); ++v) {
        const Vec3d& p = upright.vertices[v];
        const double z =
            p.z() + (beta - 1) * std::sinh(a2 * p.z()) / (a2 * std::cosh(a2 * height / 2));
        const Vec3d error = turn.transpose() * edited[v] - Vec3d(across * p.x(), across * p.y(), z);
        ASSERT_LT(error.head<2>().norm(), 5e-4) << "vertex " << v;
        ASSERT_LT(std::abs(error.z()), 2e-3) << "vertex " << v;  // sinh is not trilinear
      }
    }
  }
}

TEST(ReferenceFilter, CentroidStaysForConstantAlphaAndAnyGradientScale) {
  const System system = build(bumpy_sphere(4), 5);
  const auto beta = [](const Vec3d& centre) { return 1.5 + 1.5 * std::sin(4 * centre.x()); };
  const Solution solution =
      solve(system, fields(system, TransferCurve(6), beta), corner_positions(system));
  Eigen::RowVector3d moment = Eigen::RowVector3d::Zero();
  double area = 0;
  for (const Cell& cell : system.cells) {
    const Eigen::RowVectorXd weights = cell.rho.colwise().sum();
    for (int a = 0; a < 8; ++a) moment += weights[a] * solution.displacement.row(cell.corners[a]);
    area += cell.area;
  }
  EXPECT_LT((moment / area).norm(), 1e-11);
}

TEST(ReferenceFilter, EveryAwkwardMeshIsSolvedToRounding) {
  const TransferCurve curve = TransferCurve::parse("-20:50,0:5,20:500").value();
  for (const auto& [name, mesh] : awkward_meshes()) {
    SCOPED_TRACE(name);
    const System system = build(mesh, 5);
    for (const TransferCurve& metric : {TransferCurve(5), TransferCurve(50), curve}) {
      const Solution solution = solve(system, fields(system, metric, 0), corner_positions(system));
      EXPECT_LT(solution.residual, 1e-11);
      EXPECT_LT(solution.last_move, 1e-6);  // cells: 2e-8 of the diagonal
      // Smoothing keeps every vertex near the box: no vertex runs away or becomes NaN.
      const Distance moved = vertex_distance(displaced_vertices(system, solution.displacement),
                                             mesh.vertices, box_diagonal(mesh));
      EXPECT_LT(moved.max, 1);
      EXPECT_GT(moved.max, 1e-6);
    }
  }
}

TEST(ReferenceFilter, SaysWhenAlmostFlatPartsLeaveTheAnswerOpen) {
  // The Gaussian's tail bends a part parallel to the grid by 1e-12 of a cell and less.
  const TriangleMesh mesh = grid_surface(60, 60, false, [](double u, double v) {
    return Vec3d(u, v, 0.15 * std::exp(-((u - 0.4) * (u - 0.4) + (v - 0.5) * (v - 0.5)) / 0.02));
  });
  const System system = build(mesh, 5);
  const Solution solution =
      solve(system, fields(system, TransferCurve(5), 0), corner_positions(system));
  EXPECT_GT(solution.last_move, 1e-5);
  EXPECT_LT(solution.last_move, 1e-1);
}

TEST(ReferenceFilter, UnreferencedVerticesStay) {
  const TriangleMesh mesh = sphere_with_debris(3);
  const System system = build(mesh, 5);
  const std::vector<Vec3d> edited = edited_vertices(system, fields(system, TransferCurve(5), 0));
  EXPECT_EQ(edited[3], Vec3d(1000, -2000, 3000));
  EXPECT_EQ(edited.back(), Vec3d(0, 0, 0));
  EXPECT_NE(edited[4], mesh.vertices[4]);
}

}  // namespace
}  // namespace burnish::reference
