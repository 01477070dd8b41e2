#include "server/solver/cpu/smoothers/patch_solver.h"

#include <cmath>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "common/base/parallel.h"
#include "server/solver/cpu/products/products.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

using Vector = std::vector<Float4>;

class PatchSolverTest : public testing::Test {
 protected:
  PatchSolverTest() : system_(reference::small_components_over_a_sphere(), 5) {
    system_.fields.set_transfer_curve(TransferCurve(5));
    depths_ = system_.assembled();
    solver_.emplace(patches());
    solver_->factor(finest());
  }

  CpuDepth& finest() { return depths_.back(); }
  const Patches& patches() { return system_.plan->patches; }

  // Returns noise in which every corner weighs the same in the norm of the scaled matrix.
  Vector noise(int seed) {
    std::mt19937 random(seed);
    Vector f(finest().corner_count(), Float4::Zero());
    for (int32_t i = 0; i < finest().corner_count(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        if (const float inverse = finest().inverse_diagonal[i]; inverse > 0)
          f[i][axis] = (static_cast<float>(random()) / 4294967296.0f - 0.5f) / std::sqrt(inverse);
    return f;
  }

  Vector relaxed_from_zero(const Vector& f, void (PatchSolver::*relax)(CpuDepth&) const) {
    finest().f = f;
    std::ranges::fill(finest().x, Float4(Float4::Zero()));
    (*solver_.*relax)(finest());
    return finest().x;
  }

  TestSystem system_;
  std::vector<CpuDepth> depths_;
  std::optional<PatchSolver> solver_;
};

double product(const Vector& x, const Vector& y) {
  double sum = 0;
  for (size_t i = 0; i < x.size(); ++i) sum += (x[i].cast<double>() * y[i].cast<double>()).sum();
  return sum;
}

TEST_F(PatchSolverTest, LeavesNoResidualInThePatchesOfTheLastColour) {
  ASSERT_GT(patches().count(), 20);
  const Vector f = noise(1);
  relaxed_from_zero(f, &PatchSolver::relax_forwards);
  compute_residual(finest());
  const int32_t first = patches().colour_start[patches().colour_count() - 1];
  double left = 0, before = 0;
  for (int32_t k = patches().start[first]; k < patches().start.back(); ++k) {
    const int32_t corner = patches().corner[k];
    const float scale = finest().inverse_diagonal[corner];
    left += scale * finest().r[corner].square().sum();
    before += scale * f[corner].square().sum();
  }
  EXPECT_GT(before, 0);
  EXPECT_LT(std::sqrt(left), 0.01 * std::sqrt(before));
}

TEST_F(PatchSolverTest, TouchesNoOtherCorner) {
  const Vector x = relaxed_from_zero(noise(2), &PatchSolver::relax_forwards);
  std::vector<char> in_patch(x.size());
  for (const int32_t corner : patches().corner) in_patch[corner] = true;
  for (size_t i = 0; i < x.size(); ++i) ASSERT_TRUE(in_patch[i] || (x[i] == 0).all());
}

TEST_F(PatchSolverTest, BackwardsIsTheTransposeOfForwards) {
  const Vector f = noise(3), g = noise(4);
  const double one = product(g, relaxed_from_zero(f, &PatchSolver::relax_forwards));
  const double other = product(f, relaxed_from_zero(g, &PatchSolver::relax_backwards));
  const double norm = std::sqrt(product(f, relaxed_from_zero(f, &PatchSolver::relax_forwards)) *
                                product(g, relaxed_from_zero(g, &PatchSolver::relax_forwards)));
  EXPECT_NEAR(one / norm, other / norm, 1e-3);
}

TEST_F(PatchSolverTest, AnyNumberOfThreadsGivesTheSameBits) {
  const Vector f = noise(5);
  use_threads(1);
  const Vector one = relaxed_from_zero(f, &PatchSolver::relax_forwards);
  use_threads(3);
  const Vector three = relaxed_from_zero(f, &PatchSolver::relax_forwards);
  use_threads(0);
  for (size_t i = 0; i < one.size(); ++i) ASSERT_TRUE((one[i] == three[i]).all());
}

}  // namespace
}  // namespace burnish::cpu
