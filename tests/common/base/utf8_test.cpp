#include <random>

#include <gtest/gtest.h>

#include "common/base/text.h"

namespace burnish {
namespace {

using namespace std::string_literals;

TEST(Utf8, CharactersOfAllLengthsAreValid) {
  for (const std::string& text :
       {""s, "a\0b"s, "M\xc3\xbcller"s, "\xc2\x80"s, "\xdf\xbf"s, "\xe0\xa0\x80"s, "\xed\x9f\xbf"s,
        "\xee\x80\x80"s, "\xef\xbf\xbf"s, "\xf0\x90\x80\x80"s, "\xf4\x8f\xbf\xbf"s}) {
    EXPECT_TRUE(is_valid_utf8(text)) << testing::PrintToString(text);
    EXPECT_EQ(to_valid_utf8(text), text);
  }
}

TEST(Utf8, CutOffOverlongSurrogateAndTooLargeFormsAreNotValid) {
  for (const std::string& text :
       {"M\xfcller"s, "\x80"s, "\xbf"s, "\xc3"s, "\xc3("s, "\xe2\x82"s, "\xe2(\xa1"s,
        "\xf0\x9f\x98"s, "\xc0\x80"s, "\xc1\xbf"s, "\xe0\x9f\xbf"s, "\xf0\x8f\xbf\xbf"s,
        "\xed\xa0\x80"s, "\xed\xbf\xbf"s, "\xf4\x90\x80\x80"s, "\xf5\x80\x80\x80"s, "\xfe"s,
        "\xff"s}) {
    EXPECT_FALSE(is_valid_utf8(text)) << testing::PrintToString(text);
    EXPECT_TRUE(is_valid_utf8(to_valid_utf8(text))) << testing::PrintToString(text);
  }
}

TEST(Utf8, BytesOfNoCharacterAreWrittenInHexadecimal) {
  EXPECT_EQ(to_valid_utf8("M\xfcller"), "M\\xfcller");
  EXPECT_EQ(to_valid_utf8("\xc3\xbc\xe2\x82\\\xff"), "\xc3\xbc\\xe2\\x82\\\\\\xff");
}

TEST(Utf8, TwoTextsThatAreNotValidStayTwo) {
  EXPECT_NE(to_valid_utf8("\xfc\xfd"), to_valid_utf8("\xfc\\xfd"));
  EXPECT_NE(to_valid_utf8("\xfc"), to_valid_utf8("\xfd"));
}

TEST(Utf8, RandomBytesBecomeValid) {
  std::mt19937 random(1);
  for (int i = 0; i < 10'000; ++i) {
    std::string text(random() % 12, ' ');
    for (char& c : text) c = static_cast<char>(random() % 4 == 0 ? random() % 128 : random() % 256);
    EXPECT_TRUE(is_valid_utf8(to_valid_utf8(text))) << testing::PrintToString(text);
  }
}

}  // namespace
}  // namespace burnish
