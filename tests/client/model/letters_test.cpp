#include "client/model/workspace/letters.h"

#include <string>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Letters, ThoseOfLatinGreekAndCyrillicAreLoadedAnyway) {
  Letters letters;
  letters.add("Köpfchen β Голова");
  EXPECT_TRUE(letters.all().empty());
}

TEST(Letters, OthersAreNotedOnce) {
  Letters letters;
  letters.add("头骨 头 שלום");
  EXPECT_EQ(letters.all(), (std::set<char16_t>{u'头', u'骨', u'ש', u'ל', u'ו', u'ם'}));
}

TEST(Letters, BrokenTextAndOtherPlanesArePassedOver) {
  Letters letters;
  letters.add("\xe5\xa4");  // ends inside a letter
  letters.add(
      "\xff\x80\xe5"
      "a");  // no UTF-8
  letters.add("😀");
  EXPECT_TRUE(letters.all().empty());
  letters.add(
      "\xe5"
      "a头");
  EXPECT_EQ(letters.all().size(), 1u);
}

TEST(Letters, ThereIsALimit) {
  Letters letters;
  for (uint32_t letter = 0x4e00; letter < 0x9000; ++letter)
    letters.add(std::string{char(0xe0 | letter >> 12), char(0x80 | (letter >> 6 & 0x3f)),
                            char(0x80 | (letter & 0x3f))});
  EXPECT_EQ(letters.all().size(), Letters::kLettersMax);
}

}  // namespace
}  // namespace burnish
