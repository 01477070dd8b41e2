
#include <gtest/gtest.h>

#include "server/solver/hierarchy/pinned_below.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/reference/shapes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

// Returns the largest |row of found - row of expected| over |row of expected|. Both are symmetric.
double row_difference(const Sparse& found, const Sparse& expected) {
  const Sparse difference = found - expected;
  double worst = 0;
  for (int64_t i = 0; i < expected.cols(); ++i) {
    const double size = expected.col(i).norm();
    if (size > 0) worst = std::max(worst, difference.col(i).norm() / size);
  }
  return worst;
}

TEST(Assembly, RowSumsAreThoseOfTheMass) {
  TestSystem system(reference::bumpy_sphere(4), 5);
  system.fields.set_transfer_curve(test_curve(100));
  ExactMatrix exact(system.hierarchy->depths.back().stencil);
  const CpuDepth finest = std::move(system.assembled(&exact).back());
  const CellAlphas alphas = system.fields.alphas();
  const double scale = system.prepared->alpha_scale();
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(finest.corner_count());
  for (size_t c = 0; c < system.prepared->cells.size(); ++c)
    for (int a = 0; a < kCornersPerCell; ++a)
      expected[finest.topology.grid.cell_corners[c][a]] +=
          scale * scale * alphas.alpha1[c] * alphas.alpha2[c] *
          system.prepared->integrals[c].mass_row_sum[a];
  for (int32_t i = 0; i < finest.corner_count(); ++i)
    ASSERT_NEAR(exact.row_sum[i], expected[i], 1e-12 * expected[i]);
}

TEST(Assembly, IsSymmetric) {
  TestSystem system(reference::several_components(), 6);
  system.fields.set_transfer_curve(test_curve(100));
  for (const CpuDepth& depth : system.assembled()) {
    const Sparse s = system_matrix(depth);
    EXPECT_EQ((s - Sparse(s.transpose())).norm(), 0);
  }
}

TEST(Assembly, OfACoarseDepthIsGalerkins) {
  for (const auto& [name, mesh] : reference::awkward_meshes()) {
    SCOPED_TRACE(name);
    TestSystem system(mesh, 5);
    system.fields.set_transfer_curve(test_curve(100));
    const std::vector<CpuDepth> depths = system.assembled();
    ASSERT_GT(depths.size(), 1u);
    for (size_t i = depths.size() - 1; i > 0; --i) {
      const Sparse p = prolongation_matrix(depths[i].topology, depths[i - 1].topology);
      const Sparse galerkin = p.transpose() * system_matrix(depths[i]) * p;
      EXPECT_LT(row_difference(system_matrix(depths[i - 1]), galerkin), 1e-6);
    }
  }
}

TEST(Assembly, PinsOnlyCornersWithAlmostNoSurface) {
  const TestSystem system(reference::bumpy_sphere(4), 6);
  const CpuDepth finest = std::move(system.assembled().back());
  const Eigen::VectorXd diagonal = system_matrix(finest).diagonal();
  std::vector<double> sorted(diagonal.begin(), diagonal.end());
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[sorted.size() / 2];
  int pinned = 0;
  for (int32_t i = 0; i < finest.corner_count(); ++i) {
    const bool is_pinned = finest.inverse_diagonal[i] == 0;
    pinned += is_pinned;
    if (is_pinned) {
      ASSERT_LT(diagonal[i], 1.1 * kPinnedBelow * median);
    } else {
      ASSERT_NEAR(finest.inverse_diagonal[i] * diagonal[i], 1, 1e-5);
    }
  }
  EXPECT_GT(pinned, 0);
  EXPECT_LT(pinned, finest.corner_count() / 20);
}

}  // namespace
}  // namespace burnish::cpu
