#include "common/base/groups.h"

#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/parse_number.h"
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
