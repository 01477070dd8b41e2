#include "server/solver/cpu/assembly/constraint.h"

#include <gtest/gtest.h>

#include "server/solver/hierarchy/cell_matrix.h"
#include "tests/reference/reference.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

using Doubles = std::vector<Double3>;

/// A constraint of the system's metric, and its vectors.
struct Assembled {
  Assembled(const TestSystem& system, const CpuDepth& finest, const Double3& before,
            const Double3& residual)
      : constraint(*system.prepared, finest),
        b(finest.corner_count(), before),
        r(b.size(), residual) {
    constraint.set_ratio(ratios_of(system.fields.alphas()));
    constraint.assemble(system.fields.view(), b, r);
  }
  Assembled(const TestSystem& system, const CpuDepth& finest)
      : Assembled(system, finest, Double3::Zero(), Double3::Zero()) {}

  Constraint constraint;
  Doubles b, r;
};

Doubles constraint_of(const TestSystem& system, const CpuDepth& finest) {
  return Assembled(system, finest).b;
}

double largest(const Doubles& b) {
  double most = 0;
  for (const Double3& at : b) most = std::max(most, at.abs().maxCoeff());
  return most;
}

// Σ_b ℓ_ab x_b with the diagonal that makes rows of ℓ add up to zero.
TEST(Constraint, GradientsAreStiffnessTimesTheCornersPlaces) {
  const TestSystem system(reference::bumpy_sphere(2), 4);
  for (const auto& of : system.prepared->integrals.front().stiffness)
    for (int a = 0; a < kCornersPerCell; ++a)
      for (int axis = 0; axis < 3; ++axis) {
        double expected = 0;
        for (int b = 0; b < kCornersPerCell; ++b)
          if (b != a)
            expected += of[pair_index(a, b)] * (corner_offset(b) - corner_offset(a))[axis];
        EXPECT_NEAR(gradient_of([&](int pair) { return of[pair]; }, a, axis), expected, 1e-15);
      }
}

TEST(Constraint, IsNothingWhereBetaIsOne) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  const auto depths = system.assembled();
  for (const Double3& b : constraint_of(system, depths.back())) EXPECT_EQ(b.abs().maxCoeff(), 0);
}

TEST(Constraint, TakesTheResidualAlong) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_gradient_scale(0);
  const auto depths = system.assembled();
  const Double3 before(1, 2, 3), residual(0.5, 0.25, 0.125);
  const Assembled assembled(system, depths.back(), before, residual);
  for (size_t i = 0; i < assembled.b.size(); ++i)
    ASSERT_LT((assembled.r[i] - residual - (assembled.b[i] - before)).abs().maxCoeff(), 1e-12);
}

TEST(Constraint, AfterADabIsBitForBitWhatAFullSumGives) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  system.fields.set_gradient_scale(0.5);
  const auto depths = system.assembled();
  Assembled dabbed(system, depths.back());
  const Doubles undabbed = dabbed.b;
  dabbed.r.assign(undabbed.size(), Double3::Zero());

  system.fields.paint({{.radius = 0.3, .strength = 1, .beta = 2}, {system.prepared->vertices[0]}});
  dabbed.constraint.assemble(system.fields.view(), dabbed.b, dabbed.r);
  const Doubles full = constraint_of(system, depths.back());
  size_t changed = 0;
  for (size_t i = 0; i < full.size(); ++i) {
    ASSERT_TRUE((dabbed.b[i] == full[i]).all());
    ASSERT_TRUE((dabbed.r[i] == dabbed.b[i] - undabbed[i]).all());
    changed += (dabbed.b[i] != undabbed[i]).any();
  }
  EXPECT_GT(changed, 0u);
  EXPECT_LT(changed, full.size() / 2);
}

// Each edit leaves something unchanged that a later one may need.
TEST(Constraint, AfterSlidersAndPaintInTurnIsWhatAFullSumGives) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  const auto depths = system.assembled();
  Assembled edited(system, depths.back());
  const auto expect_sound = [&](const char* edit) {
    edited.constraint.assemble(system.fields.view(), edited.b, edited.r);
    const Doubles full = constraint_of(system, depths.back());
    const double least = 1e-14 * largest(full);
    for (size_t i = 0; i < full.size(); ++i) {
      ASSERT_LE((edited.b[i] - full[i]).abs().maxCoeff(), least) << edit;
      ASSERT_LE((edited.r[i] - edited.b[i]).abs().maxCoeff(), 10 * least) << edit;
    }
  };
  const Vec3d at(system.prepared->vertices[0]), there(system.prepared->vertices[40]);
  system.fields.set_gradient_scale(0);
  expect_sound("slider");
  system.fields.paint({{.radius = 0.3, .strength = 0.5, .beta = 2}, {at}});
  expect_sound("paint");
  system.fields.set_gradient_scale(1.5);
  expect_sound("slider beside paint");
  system.fields.set_gradient_scale(3);
  system.fields.paint({{.radius = 0.3, .strength = 0.7, .beta = 0}, {there}});
  expect_sound("both");
  system.fields.set_painted({});
  expect_sound("no paint");
}

// Another α for all cells leaves b unchanged, except at corners that become pinned or free.
TEST(Constraint, AfterANewMetricWithTheSameRatiosIsBitForBitWhatAFullSumGives) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(TransferCurve(1));
  system.fields.set_gradient_scale(0.5);
  system.fields.paint({{.radius = 0.3, .strength = 1, .beta = 2}, {system.prepared->vertices[0]}});
  auto depths = system.assembled();
  std::vector<float>& inverse_diagonal = depths.back().inverse_diagonal;
  for (size_t i = 0; i < inverse_diagonal.size(); i += 10) inverse_diagonal[i] = 0;
  Assembled edited(system, depths.back());

  system.fields.set_transfer_curve(TransferCurve(50));
  inverse_diagonal = system.assembled().back().inverse_diagonal;
  for (size_t i = 5; i < inverse_diagonal.size(); i += 10) inverse_diagonal[i] = 0;
  const FieldsView view = system.fields.view();
  edited.constraint.set_ratio(ratios_of(system.fields.alphas()));
  edited.constraint.assemble(view, edited.b, edited.r);
  const Doubles full = constraint_of(system, depths.back());
  for (size_t i = 0; i < full.size(); ++i) ASSERT_TRUE((edited.b[i] == full[i]).all()) << i;
}

TEST(Constraint, OfASliderThatComesBackToOneIsNothingAgain) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  const auto depths = system.assembled();
  Assembled edited(system, depths.back());
  for (const double beta : {0.3, 2.7, 1.0}) {
    system.fields.set_gradient_scale(beta);
    edited.constraint.assemble(system.fields.view(), edited.b, edited.r);
  }
  EXPECT_EQ(largest(edited.b), 0);
}

/// The same matrices for all cells: multiples of 1.
struct EvenTarget {
  EvenTarget(const TestSystem& system, float of_scale, float of_target)
      : cells(system.prepared->cells.size()) {
    for (TargetGradient& cell : cells)
      for (const int diagonal : {0, 4, 8}) {
        cell.of_scale[diagonal] = of_scale;
        cell.of_target[diagonal] = of_target;
      }
  }

  FieldsView in(FieldsView view, double strength) const {
    view.target = {cells, strength, 1};
    return view;
  }

  std::vector<TargetGradient> cells;
};

void expect_same(const Doubles& found, const Doubles& expected) {
  const double least = 1e-13 * largest(expected);
  for (size_t i = 0; i < found.size(); ++i)
    ASSERT_LE((found[i] - expected[i]).abs().maxCoeff(), least) << i;
}

TEST(Constraint, OfATargetOfNoStrengthIsBitForBitThePlainOne) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  system.fields.set_gradient_scale(2);
  const auto depths = system.assembled();
  Assembled edited(system, depths.back());
  const Doubles plain = edited.b;
  const EvenTarget target(system, 0.5, -0.25);
  edited.constraint.assemble(target.in(system.fields.view(), 1), edited.b, edited.r);
  EXPECT_NE(largest(edited.b), largest(plain));
  edited.constraint.assemble(target.in(system.fields.view(), 0), edited.b, edited.r);
  for (size_t i = 0; i < plain.size(); ++i) ASSERT_TRUE((edited.b[i] == plain[i]).all());
}

// With even matrices (β−1)(1 + s t1) + s t2 is what another β has less one.
TEST(Constraint, OfAnEvenTargetIsThatOfAnotherBeta) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  const auto depths = system.assembled();
  const EvenTarget target(system, 0.5, -0.25);
  for (const double strength : {0.5, 1.0})
    for (const double beta : {0.0, 1.0, 3.0}) {
      system.fields.set_gradient_scale(beta);
      Assembled edited(system, depths.back());
      edited.constraint.assemble(target.in(system.fields.view(), strength), edited.b, edited.r);
      system.fields.set_gradient_scale(1 + (beta - 1) * (1 + 0.5 * strength) - 0.25 * strength);
      expect_same(edited.b, constraint_of(system, depths.back()));
      expect_same(edited.r, edited.b);
    }
}

TEST(Constraint, AfterSlidersPaintAndTargetsInTurnIsWhatAFullSumGives) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_transfer_curve(test_curve(100));
  const auto depths = system.assembled();
  const EvenTarget target(system, 0.5, -0.25);
  Assembled edited(system, depths.back());
  const auto expect_sound = [&](double strength) {
    const FieldsView view = target.in(system.fields.view(), strength);
    edited.constraint.assemble(view, edited.b, edited.r);
    Assembled fresh(system, depths.back());
    fresh.constraint.assemble(view, fresh.b, fresh.r);
    expect_same(edited.b, fresh.b);
    expect_same(edited.r, edited.b);
  };
  expect_sound(1);
  system.fields.set_gradient_scale(3);
  expect_sound(1);
  system.fields.paint(
      {{.radius = 0.3, .strength = 0.5, .beta = 2}, {system.prepared->vertices[0]}});
  expect_sound(1);
  system.fields.set_gradient_scale(0.5);
  expect_sound(0.25);
  expect_sound(0);
}

TEST(Constraint, SumsToZeroOverTheCorners) {
  TestSystem system(reference::bumpy_sphere(3), 5);
  system.fields.set_gradient_scale(0);
  const auto depths = system.assembled();
  Double3 sum = Double3::Zero(), size = Double3::Zero();
  for (const Double3& b : constraint_of(system, depths.back())) {
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
  const std::vector<Double3> found = constraint_of(system, depths.back());

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
