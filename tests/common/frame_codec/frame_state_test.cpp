#include "common/frame_codec/frame_state.h"

#include <gtest/gtest.h>

#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

class FrameStateTest : public testing::Test {
 protected:
  std::vector<int32_t> tile(const FrameState& state) const {
    std::vector<int32_t> values(3 * kTileValues);
    state.read_tile(0, values);
    return values;
  }

  std::shared_ptr<const FrameLayout> layout_ = small_layout(FrameContent::kCoefficients);
  FrameState state_{*layout_};
};

TEST_F(FrameStateTest, BeginsWithZero) {
  EXPECT_EQ(tile(state_), std::vector<int32_t>(3 * kTileValues, 0));
}

TEST_F(FrameStateTest, KeepsValuesOfTwoAndOfFourBytes) {
  for (const int32_t extreme : {32767, -32768, 32768, -32769, 1 << 30}) {
    std::vector<int32_t> values(3 * kTileValues, 3);
    values[100] = extreme;
    state_.write_tile(0, values);
    EXPECT_EQ(tile(state_), values) << extreme;
  }
}

TEST_F(FrameStateTest, TwoBytesAValueWhereTheyFit) {
  std::vector<int32_t> values(3 * kTileValues, -32768);
  state_.write_tile(0, values);
  const uint64_t narrow = state_.byte_count();
  values[0] = -32769;
  state_.write_tile(0, values);
  EXPECT_EQ(state_.byte_count() - narrow, 3 * kTileValues * 2u);
}

TEST_F(FrameStateTest, ACopyIsNotChangedWithTheOriginal) {
  state_.write_tile(0, std::vector<int32_t>(3 * kTileValues, 1));
  const FrameState copy = state_;
  EXPECT_TRUE(copy.shares_tile(state_, 0));
  state_.write_tile(0, std::vector<int32_t>(3 * kTileValues, 2));
  EXPECT_FALSE(copy.shares_tile(state_, 0));
  EXPECT_TRUE(copy.shares_tile(state_, 1));
  EXPECT_EQ(tile(copy)[0], 1);
}

TEST_F(FrameStateTest, DisplacementsAreWrittenWhereTheyBelongInCells) {
  std::vector<int32_t> values(3 * kTileValues, 0);
  values[9] = 128;
  values[kTileValues + 9] = -64;
  values[2 * kTileValues + 9] = 1;
  state_.write_tile(0, values);
  std::vector<Vec3f> displacements(small_scan().grid.corners.size(), Vec3f(9, 9, 9));
  write_displacement(*layout_, state_, 0, displacements);
  EXPECT_EQ(displacements[layout_->source[9]], Vec3f(0.5F, -0.25F, 1 / 256.F));
  EXPECT_EQ(displacements[layout_->source[8]], Vec3f(0, 0, 0));
  EXPECT_EQ(displacements[layout_->source[kTileValues]], Vec3f(9, 9, 9));
}

}  // namespace
}  // namespace burnish
