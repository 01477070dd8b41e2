#include "common/frame_codec/tile_prediction.h"

#include <random>

#include <gtest/gtest.h>

#include "common/frame_codec/frame_header.h"
#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

std::vector<int32_t> random_change(size_t count, int32_t reach) {
  std::mt19937 random(11);
  std::uniform_int_distribution<int32_t> any(-reach, reach);
  std::vector<int32_t> change(count);
  for (int32_t& value : change) value = any(random);
  return change;
}

class TilePrediction : public testing::TestWithParam<int> {
 protected:
  std::shared_ptr<const FrameLayout> layout_ = small_layout(FrameContent::kCoefficients);
  TileRules rules_ = rules_of(*layout_, 1);
  std::vector<int32_t> k_ = std::vector<int32_t>(3 * kTileValues);
  std::vector<uint32_t> residuals_ = std::vector<uint32_t>(3 * kTileValues);
};

TEST_P(TilePrediction, IsUndoneExactly) {
  for (const int32_t reach : {1, 50, 40000, 1 << 30}) {
    round_and_predict(rules_, random_change(k_.size(), reach), GetParam(), k_, residuals_);
    std::vector<int32_t> undone(k_.size());
    undo_prediction(rules_, residuals_, undone);
    EXPECT_EQ(undone, k_);
  }
}

TEST_P(TilePrediction, RoundsWithinTheSlack) {
  const auto change = random_change(k_.size(), 5000);
  round_and_predict(rules_, change, GetParam(), k_, residuals_);
  const int half = (1 << GetParam()) / 2;
  for (size_t i = 0; i < k_.size(); ++i)
    EXPECT_LE(std::abs(change[i] - (k_[i] << GetParam())), half * rules_.slack[i % kTileValues]);
}

TEST_P(TilePrediction, APlaneAcrossTheGridLeavesFewResiduals) {
  std::vector<int32_t> change(k_.size());
  for (int i = 0; i < kTileValues; ++i) {
    const int32_t corner = layout_->source[layout_->tile_begin(1) + i];
    const Vec3i p = morton_point(small_scan().grid.corners[corner].place);
    change[i] = (5 * p.x() - 3 * p.y() + p.z() - 7) << GetParam();
  }
  round_and_predict(rules_, change, GetParam(), k_, residuals_);
  EXPECT_LT(std::ranges::count_if(residuals_, [](uint32_t r) { return r != 0; }), kTileValues / 2);
}

TEST_P(TilePrediction, ATileWithinItsSlackIsTheOneWithoutSteps) {
  for (const int32_t reach : {0, 1, 2, 3, 5, 70}) {
    const auto change = random_change(k_.size(), reach);
    round_and_predict(rules_, change, GetParam(), k_, residuals_);
    const bool no_step = std::ranges::count(k_, 0) == static_cast<std::ptrdiff_t>(k_.size());
    EXPECT_EQ(is_within_slack(rules_, change, GetParam()), no_step) << reach;
  }
}

TEST_P(TilePrediction, ChangesAddUpModulo32Bits) {
  std::vector<int32_t> values = {5, -7, INT32_MAX};
  apply_change(std::vector<int32_t>{1, -1, 1}, GetParam(), values);
  const int32_t step = 1 << GetParam();
  EXPECT_EQ(values, (std::vector<int32_t>{5 + step, -7 - step, INT32_MIN + step - 1}));
}

INSTANTIATE_TEST_SUITE_P(StepShifts, TilePrediction, testing::Values(0, 2, kStepShiftMax));

}  // namespace
}  // namespace burnish
