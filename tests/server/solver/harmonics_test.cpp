// Spherical harmonics of order two and three as scalar signals, filtered by the assembled system.
// tests/backends checks the backends' work on the coordinates, which are of order one.

#include <cmath>

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

constexpr double kAlpha = 10;

using Signals = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// xy and xyz lie in the trial space; the zonal 3z² − 1 does not.
Eigen::RowVector3d harmonics(const Vec3d& p) {
  return {p.x() * p.y(), p.x() * p.y() * p.z(), 3 * p.z() * p.z() - 1};
}
const Vec3d kOrder = {2, 3, 2};

// S of the finest depth in double.
Sparse exact_matrix(const TestSystem& system) {
  const HierarchyDepth& finest = system.hierarchy->depths.back();
  const Stencil& stencil = finest.stencil;
  cpu::ExactMatrix exact(stencil);
  system.assembled(&exact);
  std::vector<Eigen::Triplet<double>> entries;
  for (int32_t i = 0; i < finest.grid.corner_count(); ++i) {
    double diagonal = exact.row_sum[i];
    for (auto [k, end] = stencil.row(i); k < end; ++k) {
      entries.emplace_back(i, stencil.column[k], exact.entry[k]);
      diagonal -= exact.entry[k];
    }
    entries.emplace_back(i, i, diagonal);
  }
  Sparse matrix(finest.grid.corner_count(), finest.grid.corner_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

class SphericalHarmonics : public testing::Test {
 protected:
  // Returns, per signal, the root mean square over the vertices of the filtered signal less H times
  // it, at β = 0.
  Vec3d error(int depth) const {
    TestSystem system(sphere_, depth);
    const SparseGrid& grid = system.hierarchy->at(depth).grid;
    Signals signal(grid.corner_count(), 3);
    for (int32_t i = 0; i < grid.corner_count(); ++i)
      signal.row(i) = harmonics(
          system.prepared->frame.to_file(morton_point(grid.corners[i].place).cast<double>()));
    const Signals filtered = filter(system, signal);
    std::vector<Vec3d> at_corner(grid.corner_count());
    for (int32_t i = 0; i < grid.corner_count(); ++i) at_corner[i] = filtered.row(i).transpose();

    Vec3d sum = Vec3d::Zero();
    for (size_t v = 0; v < sphere_.vertices.size(); ++v) {
      const Vec3d expected =
          transfer(*system.prepared).cwiseProduct(harmonics(sphere_.vertices[v]).transpose());
      const Vec3d found = evaluate<Vec3d>(grid, system.prepared->evaluation[v], at_corner);
      sum += (found - expected).cwiseAbs2();
    }
    return (sum / static_cast<double>(sphere_.vertices.size())).cwiseSqrt();
  }

 private:
  // α² / (α² + λ²) with λ² = order (order + 1) on the unit sphere.
  static Vec3d transfer(const PreparedMesh& prepared) {
    const double a2 = std::pow(kAlpha / prepared.length_unit, 2);
    const Vec3d lambda2 = kOrder.cwiseProduct(kOrder + Vec3d::Ones());
    return (a2 / (a2 + lambda2.array())).matrix();
  }

  // Solves (α² M + L) x = α² M f: Eq. 4 at β = 0. α² M is a third of the difference of S at 2 α and
  // at α.
  static Signals filter(TestSystem& system, const Signals& signal) {
    system.fields.set_transfer_curve(TransferCurve(kAlpha));
    const Sparse s = exact_matrix(system);
    system.fields.set_transfer_curve(TransferCurve(2 * kAlpha));
    const Sparse mass = (exact_matrix(system) - s) / 3;
    return Eigen::SimplicialLDLT<Sparse>(s).solve(mass * signal);
  }

  const TriangleMesh sphere_ = reference::icosphere(6, 1);
};

TEST_F(SphericalHarmonics, OfTheTrialSpaceAreScaledToTheMeshsError) {
  const Vec3d error_at_5 = error(5);
  EXPECT_LT(error_at_5.x(), 4e-5);
  EXPECT_LT(error_at_5.y(), 1e-5);
}

TEST_F(SphericalHarmonics, OutsideTheTrialSpaceConvergeWithOrderTwo) {
  const double order = std::log2(error(4).z() / error(5).z());
  EXPECT_GT(order, 1.7);
  EXPECT_LT(order, 2.2);
}

}  // namespace
}  // namespace burnish
