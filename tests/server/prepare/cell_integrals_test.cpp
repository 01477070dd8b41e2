#include "server/prepare/cell_integrals.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "common/grid/sparse_grid.h"

namespace burnish {
namespace {

using Matrix8 = Eigen::Matrix<double, 8, 8>;
using Vector8 = Eigen::Matrix<double, 8, 1>;

// A skew pentagon inside the unit cell, and orthonormal directions in its plane.
struct Piece {
  Polygon polygon;
  Vec3d v1, v2;
};

Piece sample_piece(double turn = 0.4) {
  const Vec3d middle(0.45, 0.5, 0.55), normal = Vec3d(1, -2, 1.5).normalized();
  const Vec3d u = normal.unitOrthogonal(), v = normal.cross(u);
  Piece piece;
  for (int i = 0; i < 5; ++i) {
    const double angle = 1.2566 * i + 0.3 * (i % 2);
    piece.polygon.push(middle + 0.4 * (std::cos(angle) * u + std::sin(angle) * v));
  }
  piece.v1 = std::cos(turn) * u + std::sin(turn) * v;
  piece.v2 = normal.cross(piece.v1);
  return piece;
}

CellIntegrator integrator_of(const Piece& piece, bool umbilic = false) {
  CellIntegrator integrator;
  integrator.add(piece.polygon, piece.v1, piece.v2, umbilic);
  return integrator;
}

// The same integrals by splitting every triangle into 4096 and evaluating at the edges' midpoints.
struct BruteForce {
  double area = 0;
  Matrix8 mass = Matrix8::Zero();
  std::array<Matrix8, 2> stiffness = {Matrix8::Zero(), Matrix8::Zero()};
  std::array<Eigen::Matrix<double, 8, 3>, 2> gradient = {Eigen::Matrix<double, 8, 3>::Zero(),
                                                         Eigen::Matrix<double, 8, 3>::Zero()};
  std::array<Vec3d, 2> directions;

  explicit BruteForce(const Piece& piece) : directions{piece.v1, piece.v2} {
    const auto& p = piece.polygon.vertices;
    for (int i = 2; i < piece.polygon.count; ++i) add_split(p[0], p[i - 1], p[i], 6);
  }

  void add_split(const Vec3d& p, const Vec3d& q, const Vec3d& r, int splits) {
    const Vec3d pq = (p + q) / 2, qr = (q + r) / 2, rp = (r + p) / 2;
    if (splits == 0) {
      const double third = (q - p).cross(r - p).norm() / 6;
      for (const Vec3d& x : {pq, qr, rp}) add_point(x, third);
      return;
    }
    add_split(p, pq, rp, splits - 1);
    add_split(pq, q, qr, splits - 1);
    add_split(rp, qr, r, splits - 1);
    add_split(pq, qr, rp, splits - 1);
  }

  void add_point(const Vec3d& x, double weight) {
    Vector8 value;
    Eigen::Matrix<double, 8, 3> slope;
    for (int a = 0; a < 8; ++a) {
      const Vec3i at = corner_offset(a);
      Vec3d hat, sign;
      for (int axis = 0; axis < 3; ++axis) {
        hat[axis] = at[axis] ? x[axis] : 1 - x[axis];
        sign[axis] = at[axis] ? 1 : -1;
      }
      value[a] = hat.prod();
      slope.row(a) << sign[0] * hat[1] * hat[2], hat[0] * sign[1] * hat[2],
          hat[0] * hat[1] * sign[2];
    }
    area += weight;
    mass += weight * value * value.transpose();
    for (int i = 0; i < 2; ++i) {
      const Vector8 along = slope * directions[i];
      stiffness[i] += weight * along * along.transpose();
      gradient[i] += weight * along * directions[i].transpose();
    }
  }
};

// Returns the stored pairs as a full matrix with row sums of zero.
Matrix8 expanded(const std::array<double, 28>& pairs) {
  Matrix8 full = Matrix8::Zero();
  for (int a = 0, pair = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b, ++pair) full(a, b) = full(b, a) = pairs[pair];
  full.diagonal() = -full.rowwise().sum();
  return full;
}

TEST(CellIntegrals, MassIsThatOfFineSubdivision) {
  const BruteForce expected(sample_piece());
  CellIntegrator integrator = integrator_of(sample_piece());
  EXPECT_NEAR(integrator.area(), expected.area, 1e-12);
  const CellIntegrals stored = integrator.integrals();
  for (int a = 0, pair = 0; a < 8; ++a) {
    EXPECT_NEAR(stored.mass_row_sum[a], expected.mass.row(a).sum(), 1e-7 * expected.area);
    for (int b = a + 1; b < 8; ++b, ++pair)
      EXPECT_NEAR(stored.mass[pair], expected.mass(a, b), 1e-8 * expected.area);
  }
}

TEST(CellIntegrals, MassSumsToTheArea) {
  CellIntegrator integrator = integrator_of(sample_piece());
  double sum = 0;
  for (double row : integrator.integrals().mass_row_sum) sum += row;
  EXPECT_NEAR(sum, integrator.area(), 1e-14);
}

TEST(CellIntegrals, StiffnessWithItsDiagonalFromTheRowSumsIsThatOfFineSubdivision) {
  const BruteForce expected(sample_piece());
  const CellIntegrals stored = integrator_of(sample_piece()).integrals();
  for (int i = 0; i < 2; ++i) {
    const Matrix8 error = expanded(stored.stiffness[i]) - expected.stiffness[i];
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 2e-7 * expected.area) << "direction " << i + 1;
  }
}

// After two roundings to float32 they must still be definite, on graphics cards too.
TEST(CellIntegrals, OfASliverLeaveNoFunctionButTheConstantWithoutStiffness) {
  Piece sliver = sample_piece();
  for (int i = 0; i < sliver.polygon.count; ++i)
    sliver.polygon.vertices[i] =
        Vec3d(0.45, 0.5, 0.55) + 1e-5 * (sliver.polygon.vertices[i] - Vec3d(0.45, 0.5, 0.55));
  CellIntegrator integrator = integrator_of(sliver);
  const CellIntegrals stored = integrator.integrals();
  const Matrix8 stiffness = expanded(stored.stiffness[0]) + expanded(stored.stiffness[1]);
  const Vector8 energies = Eigen::SelfAdjointEigenSolver<Matrix8>(stiffness).eigenvalues();
  EXPECT_LT(std::abs(energies[0]), 1e-14 * integrator.area());
  EXPECT_GT(energies[1], 0.1 * kCellStiffness * integrator.area());
}

TEST(CellIntegrals, StiffnessTimesTheCornersPlacesIsTheGradientOfFineSubdivision) {
  const BruteForce expected(sample_piece());
  const CellIntegrals stored = integrator_of(sample_piece()).integrals();
  Eigen::Matrix<double, 8, 3> places;
  for (int a = 0; a < 8; ++a) places.row(a) = corner_offset(a).cast<double>();
  for (int i = 0; i < 2; ++i) {
    const Eigen::Matrix<double, 8, 3> error =
        expanded(stored.stiffness[i]) * places - expected.gradient[i];
    EXPECT_LT(error.rowwise().norm().maxCoeff(), 3e-7 * expected.area) << "direction " << i + 1;
  }
}

TEST(CellIntegrals, OfAnUmbilicPieceShareBothDirectionsEvenly) {
  const CellIntegrals stored = integrator_of(sample_piece(), true).integrals();
  EXPECT_EQ(stored.stiffness[0], stored.stiffness[1]);
  const CellIntegrals own = integrator_of(sample_piece(), false).integrals();
  const Matrix8 both = expanded(own.stiffness[0]) + expanded(own.stiffness[1]);
  EXPECT_LT((2 * expanded(stored.stiffness[0]) - both).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(CellIntegrals, OfAnUmbilicPieceDoNotDependOnTheDirections) {
  const CellIntegrals one = integrator_of(sample_piece(0.4), true).integrals();
  const CellIntegrals other = integrator_of(sample_piece(1.3), true).integrals();
  EXPECT_LT((expanded(one.stiffness[0]) - expanded(other.stiffness[0])).norm(), 1e-7);
}

TEST(CellIntegrals, DoNotDependOnHowThePieceIsCut) {
  const Piece whole = sample_piece();
  Piece low = whole, high = whole;
  low.polygon = clip(whole.polygon, 2, 0.6, -1);
  high.polygon = clip(whole.polygon, 2, 0.6, 1);
  CellIntegrator parts = integrator_of(low);
  parts.add(high.polygon, whole.v1, whole.v2, false);
  const CellIntegrals expected = integrator_of(whole).integrals(), found = parts.integrals();
  for (int pair = 0; pair < 28; ++pair) {
    EXPECT_NEAR(found.mass[pair], expected.mass[pair], 1e-8);
    EXPECT_NEAR(found.stiffness[1][pair], expected.stiffness[1][pair], 1e-7);
  }
}

TEST(CellIntegrals, OfManyPiecesAreTheSumOfEach) {
  const Piece piece = sample_piece();
  CellIntegrator seven;
  for (int i = 0; i < 7; ++i) seven.add(piece.polygon, piece.v1, piece.v2, false);
  const CellIntegrals sum = seven.integrals(), one = integrator_of(piece).integrals();
  for (int pair = 0; pair < 28; ++pair) {
    EXPECT_NEAR(sum.mass[pair], 7 * one.mass[pair], 1e-14);
    EXPECT_NEAR(sum.stiffness[0][pair], 7 * one.stiffness[0][pair], 1e-13);
  }
}

TEST(CellIntegrals, IgnoreARoundingArtefact) {
  Piece speck = sample_piece();
  for (int i = 0; i < speck.polygon.count; ++i) speck.polygon.vertices[i] *= 1e-12;
  EXPECT_EQ(integrator_of(speck).area(), 0);
}

}  // namespace
}  // namespace burnish
