#include "common/base/heard_loop.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr size_t kTooMany = size_t{1} << 34;  // a loop over them ends by a cancel alone

TEST(HeardLoop, VisitsEachOnceAndInOrder) {
  std::vector<size_t> visited;
  for_each_heard(kUnheardLoop, 5000, [&](size_t i) { visited.push_back(i); });
  std::vector<size_t> all(5000);
  std::iota(all.begin(), all.end(), size_t{0});
  EXPECT_EQ(visited, all);
}

TEST(HeardLoop, AllThreadsTogetherVisitEachOnce) {
  std::vector<int> visits(5000, 0);
  parallel_for_heard(kUnheardLoop, visits.size(), [&](size_t i) { ++visits[i]; });
  EXPECT_EQ(visits, std::vector<int>(5000, 1));
}

TEST(HeardLoop, ReportsWithinItsPart) {
  const Progress watch = [](std::string_view phase, double fraction) {
    EXPECT_EQ(phase, "grid");
    EXPECT_GE(fraction, 0.65 - 1e-9);
    EXPECT_LE(fraction, 0.7 + 1e-9);
    return true;
  };
  const LoopPart part = {watch, "grid", 0.6, 0.7};
  for_each_heard(part.of(0.5, 1), 100'000, [](size_t) {});
}

TEST(HeardLoop, LeavesWhenAskedASecondTime) {
  int asked = 0;
  const Progress cancel = [&](std::string_view, double) { return ++asked < 2; };
  std::atomic<size_t> visits{0};
  const auto visit = [&](size_t) { ++visits; };
  EXPECT_THROW(for_each_heard({cancel, "grid"}, kTooMany, visit), WorkCancelled);
  EXPECT_EQ(asked, 2);
  asked = 0;
  EXPECT_THROW(parallel_for_heard({cancel, "grid"}, kTooMany, visit), WorkCancelled);
  EXPECT_EQ(asked, 2);
  EXPECT_LT(visits, kTooMany);
}

TEST(HeardLoop, ASortIsLeftBetweenTwoComparisons) {
  const Progress cancel = [](std::string_view, double) { return false; };
  std::vector<int> values(100'000);
  std::iota(values.rbegin(), values.rend(), 0);
  EXPECT_THROW(sort_heard({cancel, "grid"}, values.begin(), values.end(), std::less<>()),
               WorkCancelled);
  sort_heard(kUnheardLoop, values.begin(), values.end(), std::less<>());
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
}

}  // namespace
}  // namespace burnish
