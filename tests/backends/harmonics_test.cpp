// Spherical harmonics of order two and three as scalar signals, filtered by every backend.
//
// The product filters the three coordinates. Its tables hold them only through the gradients
// ∫⟨v_i, ∇B_a⟩ v_i = Σ_b ℓ^i_ab (x, y, z)_b; with Σ_b ℓ^i_ab f_b there instead, the solver filters
// the three scalar signals f.

#include <cmath>

#include <gtest/gtest.h>

#include "server/prepare/prepare.h"
#include "server/solver/cell_matrix.h"
#include "server/solver/fields.h"
#include "tests/backends/filtered.h"
#include "tests/reference/shapes.h"

namespace burnish {
namespace {

constexpr double kAlpha = 10;
constexpr double kExact = 1e-9;
constexpr int kCyclesMax = 500;

// xy and xyz lie in the trial space; the zonal 3z² − 1 does not.
Vec3d harmonics(const Vec3d& p) {
  return {p.x() * p.y(), p.x() * p.y() * p.z(), 3 * p.z() * p.z() - 1};
}
const Vec3d kOrder = {2, 3, 2};

std::array<double, 21> gradient_of(const std::array<double, 28>& stiffness,
                                   const std::array<Vec3d, kCornersPerCell>& signal) {
  std::array<double, 21> gradient;
  for (int a = 0; a < 7; ++a) {
    Vec3d sum = Vec3d::Zero();
    for (int b = 0; b < kCornersPerCell; ++b)
      if (b != a) sum += stiffness[pair_index(a, b)] * (signal[b] - signal[a]);
    for (int axis = 0; axis < 3; ++axis) gradient[3 * a + axis] = sum[axis];
  }
  return gradient;
}

class SphericalHarmonics : public testing::TestWithParam<BackendCase> {
 protected:
  /// Root mean square over the vertices, by signal, of the filtered signal less H times it, β = 0.
  Vec3d error(int depth) {
    const auto prepared = prepare(sphere_, {.depth = depth}).value();
    const auto hierarchy = make_hierarchy(*prepared);
    const SparseGrid& grid = hierarchy->at(depth).grid;
    std::vector<Vec3d> signal(grid.corners.size());
    for (size_t i = 0; i < signal.size(); ++i)
      signal[i] =
          harmonics(prepared->frame.to_file(morton_point(grid.corners[i].place).cast<double>()));

    std::vector<CellIntegrals> integrals(prepared->integrals.begin(), prepared->integrals.end());
    for (size_t c = 0; c < integrals.size(); ++c) {
      std::array<Vec3d, kCornersPerCell> at_corner;
      for (int a = 0; a < kCornersPerCell; ++a) at_corner[a] = signal[grid.cell_corners[c][a]];
      for (int i : {0, 1})
        integrals[c].gradient[i] = gradient_of(integrals[c].stiffness[i], at_corner);
    }
    auto scalar = std::make_shared<PreparedMesh>(*prepared);
    scalar->integrals = integrals;
    const std::vector<Vec3d> filtered = filter(scalar, hierarchy, signal);

    Vec3d sum = Vec3d::Zero();
    for (size_t v = 0; v < sphere_.vertices.size(); ++v)
      sum.array() +=
          (filtered[v] - transfer(*prepared).cwiseProduct(harmonics(sphere_.vertices[v])))
              .array()
              .square();
    return (sum / static_cast<double>(sphere_.vertices.size())).cwiseSqrt();
  }

 private:
  // α² / (α² + λ²) with λ² = order (order + 1) on the unit sphere.
  static Vec3d transfer(const PreparedMesh& prepared) {
    const double a2 = std::pow(kAlpha / prepared.length_unit, 2);
    const Vec3d lambda2 = kOrder.cwiseProduct(kOrder + Vec3d::Ones());
    return (a2 / (a2 + lambda2.array())).matrix();
  }

  // The signals at the vertices: E (f + u), the displacement u read from how far vertices move.
  std::vector<Vec3d> filter(const std::shared_ptr<const PreparedMesh>& prepared,
                            const std::shared_ptr<const Hierarchy>& hierarchy,
                            const std::vector<Vec3d>& signal) {
    const auto solver = Solver::create(prepared, hierarchy, GetParam().options).value();
    Fields fields(*prepared);
    fields.set_transfer_curve(TransferCurve(kAlpha));
    fields.set_gradient_scale(0);
    solver->set_metric(fields.view());
    EXPECT_TRUE(solver->solve(kExact, kCyclesMax).value().converged);
    std::vector<Vec3d> filtered = solver->evaluate_vertices();
    const SparseGrid& grid = hierarchy->at(hierarchy->finest).grid;
    for (size_t v = 0; v < filtered.size(); ++v)
      filtered[v] = (filtered[v] - prepared->vertices[v]) / prepared->frame.cell_size +
                    evaluate<Vec3d>(grid, prepared->evaluation[v], signal);
    return filtered;
  }

  const TriangleMesh sphere_ = reference::icosphere(6, 1);
};

TEST_P(SphericalHarmonics, OfTheTrialSpaceAreScaledToTheMeshsError) {
  const Vec3d error_at_5 = error(5);
  EXPECT_LT(error_at_5.x(), 4e-5);
  EXPECT_LT(error_at_5.y(), 1e-5);
}

TEST_P(SphericalHarmonics, OutsideTheTrialSpaceConvergeWithOrderTwo) {
  const double order = std::log2(error(4).z() / error(5).z());
  EXPECT_GT(order, 1.7);
  EXPECT_LT(order, 2.2);
}

INSTANTIATE_TEST_SUITE_P(Backends, SphericalHarmonics, testing::ValuesIn(backend_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish
