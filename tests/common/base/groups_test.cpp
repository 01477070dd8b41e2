#include "common/base/groups.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/disjoint_sets.h"
#include "common/base/parallel.h"
#include "common/base/parse_number.h"
#include "common/base/select_numbers.h"
#include "common/base/sort_once.h"
#include "common/base/text.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Groups, KeepTheOrderInWhichTheirItemsCome) {
  const std::vector<std::pair<int, char>> items = {
      {2, 'a'}, {0, 'b'}, {2, 'c'}, {0, 'd'}, {3, 'e'}};
  const auto groups = group_by<char>(5, [&](auto&& add) {
    for (const auto& [group, item] : items) add(group, item);
  });
  EXPECT_EQ(groups.count(), 5u);
  EXPECT_THAT(groups[0], ElementsAre('b', 'd'));
  EXPECT_THAT(groups[1], IsEmpty());
  EXPECT_THAT(groups[2], ElementsAre('a', 'c'));
  EXPECT_THAT(groups[3], ElementsAre('e'));
  EXPECT_THAT(groups[4], IsEmpty());
  EXPECT_THAT(groups.start, ElementsAre(0, 2, 2, 4, 5, 5));
}

TEST(Groups, OfNothingAreNone) {
  EXPECT_EQ(Groups<int>().count(), 0u);
  EXPECT_EQ(group_by<int>(0, [](auto&&) {}).count(), 0u);
  EXPECT_THAT(group_by<int>(2, [](auto&&) {}).start, ElementsAre(0, 0, 0));
}

TEST(Groups, GrowByOneAtTheEnd) {
  Groups<int> groups;
  groups.add(std::vector{7, 8});
  groups.add({});
  EXPECT_EQ(groups.count(), 2u);
  EXPECT_THAT(groups[0], ElementsAre(7, 8));
  EXPECT_THAT(groups[1], IsEmpty());
}

TEST(Groups, OfNumbersRiseForAnyNumberOfThreads) {
  constexpr int32_t kCount = 100'000;
  constexpr int32_t kGroups = 1000;
  const auto group_of = [](int32_t i) { return i % 7 == 0 ? -1 : i * 31 % kGroups; };
  const auto expected = group_by<int32_t>(kGroups, [&](auto&& add) {
    for (int32_t i = 0; i < kCount; ++i)
      if (group_of(i) >= 0) add(group_of(i), i);
  });
  for (const int threads : {1, 4}) {
    use_threads(threads);
    const Groups<int32_t> made = group_numbers(kGroups, kCount, group_of);
    EXPECT_EQ(made.start, expected.start);
    EXPECT_EQ(made.item, expected.item);
  }
  EXPECT_EQ(group_numbers(3, 0, group_of).start, std::vector<int32_t>(4, 0));
}

TEST(SelectNumbers, FindsThemRisingForAnyNumberOfThreads) {
  for (const int32_t count : {0, 1, (1 << 14) - 1, 1 << 14, (1 << 14) + 1, 100'000}) {
    const auto is_taken = [](int32_t i) { return i % 3 == 0 || i % 1000 < 20; };
    std::vector<int32_t> expected;
    for (int32_t i = 0; i < count; ++i)
      if (is_taken(i)) expected.push_back(i);
    for (const int threads : {1, 4}) {
      use_threads(threads);
      EXPECT_EQ(select_numbers(count, is_taken), expected);
    }
  }
}

TEST(DisjointSets, HaveTheirLeastNumberAsRootInWhateverOrderThreadsJoin) {
  constexpr int32_t kCount = 200'000;
  use_threads(8);
  DisjointSets sets(kCount);
#pragma omp parallel for schedule(dynamic, 1)
  for (int32_t i = kCount - 1; i >= 10; --i) sets.join(i, i - 10);
  for (int32_t i = 0; i < kCount; ++i) ASSERT_EQ(sets.root(i), i % 10);
}

TEST(SortOnce, KeepsEachValueOnce) {
  std::vector<std::string> words = {"b", "a", "b"};
  sort_once(words);
  EXPECT_THAT(words, ElementsAre("a", "b"));
}

TEST(ParseNumber, TakesAllOfTheTextOrNothing) {
  EXPECT_EQ(parse_number<int>("-12"), -12);
  EXPECT_EQ(parse_number<double>("1e3"), 1000.0);
  EXPECT_EQ(parse_number<int>("12 "), std::nullopt);
  EXPECT_EQ(parse_number<int>(""), std::nullopt);
  EXPECT_EQ(parse_number<uint16_t>("65536"), std::nullopt);
  EXPECT_EQ(parse_number<uint16_t>("-1"), std::nullopt);
}

TEST(Hex, HasTwoDigitsForEachByte) {
  const std::string bytes = {'\x00', '\x9f', '\xff'};
  EXPECT_EQ(to_hex(std::as_bytes(std::span(bytes))), "009fff");
}

}  // namespace
}  // namespace burnish
