#include "server/solver/cpu/constraint.h"

#include <gtest/gtest.h>

#include "tests/reference/reference.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

std::vector<Double4> constraint_of(const TestSystem& system, const CpuDepth& finest) {
  const FieldsView view = system.fields.view();
  std::vector<Double4> b(finest.corner_count(), Double4::Zero()), r = b;
  assemble_constraint(*system.prepared, finest, ratios_of(view.alpha1, view.alpha2), view.beta, {},
                      b, r);
  return b;
}

TEST(Constraint, IsNothingWhereBetaIsOne) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  const auto depths = system.assembled();
  for (const Double4& b : constraint_of(system, depths.back())) EXPECT_EQ(b.abs().maxCoeff(), 0);
}

TEST(Constraint, TakesTheResidualAlong) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_gradient_scale(0);
  const auto depths = system.assembled();
  const FieldsView view = system.fields.view();
  const Double4 before(1, 2, 3, 0), residual(0.5, 0.25, 0.125, 0);
  std::vector<Double4> b(depths.back().corner_count(), before), r(b.size(), residual);
  assemble_constraint(*system.prepared, depths.back(), ratios_of(view.alpha1, view.alpha2),
                      view.beta, {}, b, r);
  for (size_t i = 0; i < b.size(); ++i)
    ASSERT_LT((r[i] - residual - (b[i] - before)).abs().maxCoeff(), 1e-12);
}

TEST(Constraint, AfterADabIsBitForBitWhatAFullSumGives) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  system.fields.set_gradient_scale(0.5);
  const auto depths = system.assembled();
  const std::vector<double> ratio =
      ratios_of(system.fields.view().alpha1, system.fields.view().alpha2);
  std::vector<Double4> b = constraint_of(system, depths.back()), r(b.size(), Double4::Zero());
  const std::vector<Double4> undabbed = b;
  const FieldsView view = system.fields.view();
  const std::vector<float> before(view.beta.begin(), view.beta.end());

  system.fields.paint({{.radius = 0.3, .strength = 1, .beta = 2}, {system.prepared->vertices[0]}});
  assemble_constraint(*system.prepared, depths.back(), ratio, system.fields.view().beta, before, b,
                      r);
  const std::vector<Double4> full = constraint_of(system, depths.back());
  size_t changed = 0;
  for (size_t i = 0; i < b.size(); ++i) {
    ASSERT_TRUE((b[i] == full[i]).all());
    ASSERT_TRUE((r[i] == b[i] - undabbed[i]).all());
    changed += (b[i] != undabbed[i]).any();
  }
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, b.size() / 2);
}

TEST(Constraint, SumsToZeroOverTheCorners) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_gradient_scale(0);
  const auto depths = system.assembled();
  Double4 sum = Double4::Zero(), size = Double4::Zero();
  for (const Double4& b : constraint_of(system, depths.back())) {
    sum += b;
    size += b.abs();
  }
  for (int axis = 0; axis < 3; ++axis) EXPECT_LT(std::abs(sum[axis]), 1e-9 * size[axis]);
}

TEST(Constraint, IsTheReferencesAppliedToTheCornerPositions) {
  const TriangleMesh mesh = reference::bumpy_sphere(4);
  TestSystem system(mesh, 5);
  system.fields.set_transfer_curve(test_curve(30));
  system.fields.set_gradient_scale(2.5);
  const auto depths = system.assembled();
  const std::vector<Double4> found = constraint_of(system, depths.back());

  const reference::System expected_system = reference::build(mesh, 5);
  const Eigen::MatrixXd expected = reference::constraint(
      expected_system, reference::fields(expected_system, test_curve(30), 2.5),
      reference::corner_positions(expected_system));
  const double largest = expected.cwiseAbs().maxCoeff();
  const auto& corners = expected_system.corners;
  for (int32_t i = 0; i < depths.back().corner_count(); ++i) {
    const Vec3i at = morton_point(depths.back().topology.grid.corners[i].place);
    const auto row = std::lower_bound(corners.begin(), corners.end(),
                                      reference::Lattice{at.x(), at.y(), at.z()}) -
                     corners.begin();
    const Vec3d difference = found[i].head<3>().matrix() - expected.row(row).transpose();
    ASSERT_LT(difference.norm(), 1e-6 * largest) << "corner " << at.transpose();
  }
}

}  // namespace
}  // namespace burnish::cpu
