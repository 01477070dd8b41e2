#include "server/solver/multi/shard_fields.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(ShardFields, TakeTheMetricOfTheirCellsAlone) {
  const std::vector<int32_t> cells = {2, 5, 6, 9};
  ShardFields fields(cells);
  const TransferCurve curve(7);
  const std::vector<OwnFields> own = {{1, 1, 1, 0}, {5, 2, 3, 0}, {7, 1, 1, 0}, {9, 4, 5, 0}};
  const MetricView metric = fields.metric({&curve, own});
  ASSERT_EQ(metric.own.size(), 2u);
  EXPECT_EQ(metric.own[0].cell, 1);
  EXPECT_EQ(metric.own[0].alpha2, 3);
  EXPECT_EQ(metric.own[1].cell, 3);
  EXPECT_EQ(metric.curve, &curve);
}

TEST(ShardFields, FollowPaintThatComesAndGoes) {
  constexpr size_t kCells = 5 * CellPaint::kStretch;
  std::vector<int32_t> cells;
  for (size_t c = 1; c < kCells; c += 2) cells.push_back(static_cast<int32_t>(c));
  ShardFields fields(cells);
  std::vector<float> follow(kCells, 1), own(kCells, 0);
  std::vector<uint8_t> is_painted(5, 0);
  const FieldsView whole{{}, {}, 0.5, {follow, own, is_painted}};
  const auto now = [&] { return fields.constraint(whole); };
  EXPECT_EQ(std::ranges::count(now().paint.is_painted, 1), 0);
  EXPECT_EQ(now().gradient_scale, 0.5);

  is_painted[3] = 1;
  follow[3 * CellPaint::kStretch + 1] = 0.25;
  own[3 * CellPaint::kStretch + 1] = 0.75;
  const size_t there = 3 * CellPaint::kStretch / 2;
  EXPECT_EQ(cells[there], static_cast<int32_t>(3 * CellPaint::kStretch + 1));
  EXPECT_EQ(now().paint.follow[there], 0.25f);
  EXPECT_EQ(now().paint.own[there], 0.75f);
  EXPECT_EQ(now().paint.is_painted[there / CellPaint::kStretch], 1);

  is_painted[3] = 0;
  follow[3 * CellPaint::kStretch + 1] = 1;
  own[3 * CellPaint::kStretch + 1] = 0;
  EXPECT_EQ(now().paint.follow[there], 1);
  EXPECT_EQ(std::ranges::count(now().paint.is_painted, 1), 0);
}

TEST(ShardFields, TakeTheTargetOfTheirCellsAlone) {
  const std::vector<int32_t> cells = {0, 2};
  ShardFields fields(cells);
  const std::vector<float> follow(3, 1), own(3, 0);
  const std::vector<uint8_t> is_painted(1, 0);
  std::vector<TargetGradient> target(3);
  target[2].of_target[4] = 0.5;
  FieldsView whole{{}, {}, 1, {follow, own, is_painted}, {target, 0.75, 1}};
  const TargetView taken = fields.constraint(whole).target;
  ASSERT_EQ(taken.cells.size(), 2u);
  EXPECT_EQ(taken.cells[1].of_target[4], 0.5F);
  EXPECT_EQ(taken.strength, 0.75);

  target[2].of_target[4] = 0.25;
  whole.target.version = 2;
  EXPECT_EQ(fields.constraint(whole).target.cells[1].of_target[4], 0.25F);
  whole.target.strength = 0;
  EXPECT_FALSE(fields.constraint(whole).target.is_active());
}

}  // namespace
}  // namespace burnish
