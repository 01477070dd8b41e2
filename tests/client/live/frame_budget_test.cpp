#include "client/live/frame_budget.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr double kTransferMs = FrameBudget::kTransferMs;

TEST(FrameBudget, IsUnknownBeforeAFrameThatTells) {
  FrameBudget budget;
  EXPECT_EQ(budget.bytes(), 0u);
  budget.on_frame(100, 50);
  EXPECT_EQ(budget.bytes(), 0u);
}

TEST(FrameBudget, IsWhatTheLinkCarriesInItsTime) {
  FrameBudget budget;
  for (const size_t bytes : {100'000, 20'000, 50'000}) budget.on_frame(bytes, bytes / 1000.0);
  EXPECT_NEAR(budget.bytes(), 1000 * kTransferMs, 1);
}

TEST(FrameBudget, DoesNotFollowOneLateFrame) {
  FrameBudget budget;
  for (int i = 0; i < 5; ++i) budget.on_frame(10'000, 10);
  budget.on_frame(10'000, 900);
  EXPECT_NEAR(budget.bytes(), 1000 * kTransferMs, 1);
}

TEST(FrameBudget, FollowsALinkThatBecomesSlowOrFast) {
  FrameBudget budget;
  for (int i = 0; i < 9; ++i) budget.on_frame(10'000, 1);
  for (int i = 0; i < 4; ++i) budget.on_frame(10'000, 20);
  EXPECT_NEAR(budget.bytes(), 500 * kTransferMs, 1);
  for (int i = 0; i < 4; ++i) budget.on_frame(10'000, -3);  // the clock's jitter
  EXPECT_GT(budget.bytes(), 10'000 * kTransferMs);
}

TEST(FrameBudget, IsUnknownAgainOnANewStream) {
  FrameBudget budget;
  budget.on_frame(10'000, 10);
  budget.restart();
  EXPECT_EQ(budget.bytes(), 0u);
}

}  // namespace
}  // namespace burnish
