#include "server/solver/cpu/smoothers/smoother.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "server/solver/cpu/products/coarsest.h"
#include "server/solver/cpu/products/products.h"
#include "server/solver/cpu/products/transfer.h"
#include "server/solver/cpu/smoothers/spectrum.h"
#include "server/solver/cycle/schwarz_bounds.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

using Vector = std::vector<Float4>;

// Returns noise in which every corner weighs the same in the norm of the scaled matrix; zero where
// pinned.
Vector noise(const CpuDepth& depth, int seed) {
  std::mt19937 random(seed);
  Vector f(depth.corner_count());
  for (int32_t i = 0; i < depth.corner_count(); ++i) {
    const float inverse = depth.inverse_diagonal[i];
    const float scale = inverse > 0 ? 1 / std::sqrt(inverse) : 0;
    for (int axis = 0; axis < 3; ++axis)
      f[i][axis] = scale * (static_cast<float>(random()) / 4294967296.0f - 0.5f);
    f[i][3] = 0;
  }
  return f;
}

double dot(const Vector& x, const Vector& y) {
  double sum = 0;
  for (size_t i = 0; i < x.size(); ++i) sum += (x[i].cast<double>() * y[i].cast<double>()).sum();
  return sum;
}

struct Cycle {
  Cycle(const TestSystem& system, Smoother kind) : depths(system.assembled()) {
    for (CpuDepth& depth : depths) {
      smoothers.push_back(make_smoother(kind, depth.topology));
      smoothers.back()->set_up(depth);
    }
    coarsest.factor(depths.front());
  }

  CpuDepth& finest() { return depths.back(); }

  Vector relaxed_from_zero(const Vector& f) {
    finest().f = f;
    smoothers.back()->relax_from_zero(finest());
    return finest().x;
  }

  Vector relaxed(const Vector& f) {
    finest().f = f;
    std::fill(finest().x.begin(), finest().x.end(), Float4::Zero());
    smoothers.back()->relax(finest());
    return finest().x;
  }

  Vector vcycle(const Vector& f) {
    finest().f = f;
    for (size_t i = depths.size() - 1; i > 0; --i) {
      smoothers[i]->relax_from_zero(depths[i]);
      compute_residual(depths[i]);
      restrict_to_coarse(depths[i], depths[i].r, depths[i - 1]);
    }
    coarsest.solve(depths.front());
    for (size_t i = 1; i < depths.size(); ++i) {
      add_prolonged(depths[i - 1], depths[i]);
      smoothers[i]->relax(depths[i]);
    }
    return finest().x;
  }

  std::vector<CpuDepth> depths;
  std::vector<std::unique_ptr<DepthSmoother>> smoothers;
  CoarsestSolver coarsest;
};

class SmootherTest : public testing::TestWithParam<Smoother> {
 protected:
  static TestSystem sample() {
    TestSystem system(reference::several_components(), 6);
    system.fields.set_transfer_curve(test_curve(100));
    return system;
  }

  TestSystem system_ = sample();
  Cycle cycle_{system_, GetParam()};
};

std::vector<Smoother> all_smoothers() {
  std::vector<Smoother> all;
  for (const NamedSmoother& named : kSmoothers) all.push_back(named.smoother);
  return all;
}

std::string case_name(const testing::TestParamInfo<Smoother>& smoother) {
  std::string name(name_of(smoother.param));
  std::ranges::replace(name, '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, SmootherTest, testing::ValuesIn(all_smoothers()), case_name);

// Returns the bound for float32's rounding: ten times larger with inverses of the finest depth's
// blocks, which reach 1e5.
double rounding(Smoother smoother, double otherwise) {
  const bool has_blocks = smoother == Smoother::kSchwarz || smoother == Smoother::kCellBlocks;
  return has_blocks ? 10 * otherwise : otherwise;
}

TEST_P(SmootherTest, RelaxIsTheTransposeOfRelaxFromZero) {
  const Vector x = noise(cycle_.finest(), 1), y = noise(cycle_.finest(), 2);
  const Vector mx = cycle_.relaxed_from_zero(x), my = cycle_.relaxed_from_zero(y);
  const double scale = std::sqrt(dot(x, mx) * dot(y, my));
  EXPECT_NEAR(dot(y, mx), dot(x, cycle_.relaxed(y)), rounding(GetParam(), 1e-5) * scale);
  EXPECT_GT(dot(x, mx), 0);
}

TEST_P(SmootherTest, TheVCycleIsSymmetricAndPositive) {
  ASSERT_GT(cycle_.depths.size(), 2u);
  const Vector x = noise(cycle_.finest(), 1), y = noise(cycle_.finest(), 2);
  const Vector vx = cycle_.vcycle(x), vy = cycle_.vcycle(y);
  const double scale = std::sqrt(dot(x, vx) * dot(y, vy));
  EXPECT_GT(dot(x, vx), 0);
  EXPECT_NEAR(dot(x, vy), dot(y, vx), rounding(GetParam(), 1e-4) * scale);
}

TEST_P(SmootherTest, RelaxesAlikeWhereTheSpectrumIsKnownFromBefore) {
  const Vector f = noise(cycle_.finest(), 4), before = cycle_.relaxed_from_zero(f);
  cycle_.finest().is_spectrum_new = false;
  cycle_.smoothers.back()->set_up(cycle_.finest());
  const Vector after = cycle_.relaxed_from_zero(f);
  for (size_t i = 0; i < f.size(); ++i) ASSERT_TRUE((after[i] == before[i]).all()) << i;
}

TEST_P(SmootherTest, LeavesPinnedCornersAtZero) {
  int pinned = 0;
  for (int32_t i = 0; i < cycle_.finest().corner_count(); i += 5, ++pinned)
    cycle_.finest().inverse_diagonal[i] = 0;
  cycle_.smoothers.back()->set_up(cycle_.finest());
  const Vector x = cycle_.vcycle(noise(cycle_.finest(), 3));
  for (size_t i = 0; i < x.size(); i += 5) ASSERT_EQ(x[i].abs().maxCoeff(), 0) << "corner " << i;
  EXPECT_GT(pinned, 1000);
}

TEST_P(SmootherTest, ReducesTheError) {
  // The solution of S x = 0 is 0, so x itself is the error. It is measured in S's own norm.
  CpuDepth& finest = cycle_.finest();
  const auto energy = [&] {
    std::fill(finest.f.begin(), finest.f.end(), Float4::Zero());
    compute_residual(finest);
    return -dot(finest.x, finest.r);
  };
  finest.x = noise(finest, 4);
  for (int32_t i = 0; i < finest.corner_count(); ++i) finest.x[i] *= finest.inverse_diagonal[i];
  const double before = energy();
  cycle_.smoothers.back()->relax(finest);
  EXPECT_LT(energy(), 0.7 * before);
}

// Unnormalised, fifteen iterations of such an operator leave the range of float32.
TEST(LambdaMax, ALargestEigenvalueNearTheBoundIsFound) {
  const TestSystem system(reference::awkward_meshes().front().second, 4);
  CpuDepth depth = std::move(system.assembled().back());
  const double largest = 26;
  const auto apply = [&] {
    for (size_t i = 0; i < depth.x.size(); ++i)
      depth.x[i] = depth.inverse_diagonal[i] == 0
                       ? Float4(Float4::Zero())
                       : Float4(static_cast<float>(largest) * depth.x[i]);
  };
  LambdaMax lambda_max(depth.x.size());
  EXPECT_NEAR(lambda_max.estimate(depth, {1, 100}, apply), kLambdaMaxMargin * largest, 1e-2);
}

}  // namespace
}  // namespace burnish::cpu
