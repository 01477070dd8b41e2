// The overlapping blocks of section 5.2 against a sweep over all slices.

#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/solver/cpu/smoothers/paper/slice_rows.h"
#include "server/solver/cpu/smoothers/smoother.h"
#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/test_system.h"

namespace burnish::cpu {
namespace {

using Vector = std::vector<Float4>;

struct Relaxed {
  Vector from_zero;  // relax_from_zero()
  Vector further;    // relax() after it
};

class SlicesTest : public testing::Test {
 protected:
  SlicesTest() {
    std::mt19937 random(7);
    for (int32_t i = 0; i < finest_.corner_count(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        finest_.f[i][axis] =
            finest_.system.diagonal[i] * (static_cast<float>(random()) / 4294967296.0f - 0.5f);
  }

  static TestSystem sample() {
    TestSystem system(reference::several_components(), 6);
    system.fields.set_transfer_curve(test_curve(100));
    return system;
  }

  Relaxed relax(const SliceOptions& options) {
    const auto smoother = make_slices(finest_.topology, options);
    smoother->set_up(finest_);
    Relaxed relaxed;
    smoother->relax_from_zero(finest_);
    relaxed.from_zero = finest_.x;
    smoother->relax(finest_);
    relaxed.further = finest_.x;
    return relaxed;
  }

  // Does Gauss-Seidel on S itself, corner after corner.
  void relax_corners(std::span<const int32_t> corners) {
    for (int32_t i : corners)
      finest_.x[i] +=
          finest_.inverse_diagonal[i] *
          (finest_.f[i] - product_row(finest_.topology.stencil, finest_.system, finest_.x, i));
  }

  Relaxed relax_serially(int sweeps) {
    const SliceRows rows(finest_.topology);
    std::vector<int32_t> order;
    for (int parity : {0, 1})
      for (int slice = parity; slice < rows.slice_count(); slice += 2)
        order.insert(order.end(), rows.corner.begin() + rows.slice_start[slice],
                     rows.corner.begin() + rows.slice_start[slice + 1]);
    Relaxed relaxed;
    std::fill(finest_.x.begin(), finest_.x.end(), Float4::Zero());
    for (int sweep = 0; sweep < sweeps; ++sweep) relax_corners(order);
    relaxed.from_zero = finest_.x;
    std::ranges::reverse(order);
    for (int sweep = 0; sweep < sweeps; ++sweep) relax_corners(order);
    relaxed.further = finest_.x;
    return relaxed;
  }

  // Returns the largest difference of two vectors over the largest entry, both scaled by the square
  // root of the diagonal.
  double relative_distance(const Vector& x, const Vector& y) const {
    double difference = 0, most = 0;
    for (size_t i = 0; i < x.size(); ++i) {
      const double scale = std::sqrt(finest_.system.diagonal[i]);
      difference = std::max<double>(difference, scale * (x[i] - y[i]).abs().maxCoeff());
      most = std::max<double>(most, scale * y[i].abs().maxCoeff());
    }
    return difference / most;
  }

  TestSystem system_ = sample();
  std::vector<CpuDepth> depths_ = system_.assembled();
  CpuDepth& finest_ = depths_.back();
};

void expect_same_bits(const Vector& x, const Vector& y) {
  ASSERT_EQ(x.size(), y.size());
  for (size_t i = 0; i < x.size(); ++i) ASSERT_TRUE((x[i] == y[i]).all()) << "corner " << i;
}

TEST_F(SlicesTest, SliceBlocksEqualTheSerialSweep) {
  for (int sweeps : {1, 2, 5}) {
    const Relaxed serial = relax_serially(sweeps);
    const Relaxed whole = relax({.sweeps = sweeps, .blocks = 1});
    EXPECT_LT(relative_distance(whole.from_zero, serial.from_zero), 1e-6);
    EXPECT_LT(relative_distance(whole.further, serial.further), 1e-6);
    for (int blocks : {2, 3, 5, 1000}) {
      SCOPED_TRACE(std::to_string(sweeps) + " sweeps on " + std::to_string(blocks) + " blocks");
      const Relaxed parted = relax({.sweeps = sweeps, .blocks = blocks});
      expect_same_bits(parted.from_zero, whole.from_zero);
      expect_same_bits(parted.further, whole.further);
    }
  }
}

TEST_F(SlicesTest, TemporalBlockingEqualsSweepBySweep) {
  for (int sweeps : {1, 2, 5})
    for (int blocks : {1, 2, 3, 1000}) {
      SCOPED_TRACE(std::to_string(sweeps) + " sweeps on " + std::to_string(blocks) + " blocks");
      const Relaxed plain = relax({.sweeps = sweeps, .blocks = blocks});
      const Relaxed fused = relax({.sweeps = sweeps, .blocks = blocks, .temporal_blocking = true});
      expect_same_bits(fused.from_zero, plain.from_zero);
      expect_same_bits(fused.further, plain.further);
    }
}

TEST_F(SlicesTest, NeighboursAreAtMostOneSliceApart) {
  const SliceRows rows(finest_.topology);
  for (int slice = 0; slice < rows.slice_count(); ++slice)
    for (int32_t p = rows.slice_start[slice]; p < rows.slice_start[slice + 1]; ++p)
      for (int64_t k = rows.row_start[p]; k < rows.row_start[p + 1]; ++k) {
        ASSERT_GE(rows.column[k], rows.slice_start[std::max(slice - 1, 0)]);
        ASSERT_LT(rows.column[k], rows.slice_start[std::min(slice + 2, rows.slice_count())]);
      }
  std::vector<int32_t> all(finest_.corner_count());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_THAT(rows.corner, testing::UnorderedElementsAreArray(all));
}

TEST_F(SlicesTest, RangesHoldEverySliceOnceAndShareTheCorners) {
  const SliceRows rows(finest_.topology);
  for (int count : {1, 2, 3, 7, 1000}) {
    int next = 0;
    for (const SliceRange& range : partition_slices(rows, count)) {
      EXPECT_EQ(range.first, next);
      EXPECT_LT(range.first, range.last);
      next = range.last;
    }
    EXPECT_EQ(next, rows.slice_count());
  }
  const auto halves = partition_slices(rows, 2);
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_NEAR(rows.slice_start[halves[0].last], finest_.corner_count() / 2.0,
              0.1 * finest_.corner_count());
}

}  // namespace
}  // namespace burnish::cpu
