#include "common/base/text.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(OneLine, OrdinaryTextOfAnyScriptStays) {
  const std::string text = "scan \"M\u00fcller\" \u6f22\u5b57 \U0001f600";
  EXPECT_EQ(one_line(text, 1000), text);
}

TEST(OneLine, WhatATerminalObeysBecomesAQuestionMark) {
  EXPECT_EQ(one_line("a\nb\x1b[31m\x7f", 1000), "a?b?[31m?");
  EXPECT_EQ(one_line("\u0085 \u009b \u2028 \u2029 \u202e \u2066 \u200f", 1000), "? ? ? ? ? ? ?");
}

TEST(OneLine, BytesThatAreNoUtf8BecomeQuestionMarks) {
  EXPECT_EQ(one_line("M\xfcller", 1000), "M?ller");
  EXPECT_EQ(one_line("\xc3", 1000), "?");                 // cut off
  EXPECT_EQ(one_line("\xc0\xaf", 1000), "??");            // a longer form than needed
  EXPECT_EQ(one_line("\xed\xa0\x80", 1000), "???");       // half of a surrogate pair
  EXPECT_EQ(one_line("\xf5\x80\x80\x80", 1000), "????");  // beyond the last character
  EXPECT_EQ(one_line("\xe2\x82", 1000), "??");
}

TEST(OneLine, WhatIsTooLongIsCutBetweenCharactersAndSaysSo) {
  EXPECT_EQ(one_line("aaaa\u00fcbbb", 5), "aaaa... (5 more bytes)");
  EXPECT_LT(one_line(std::string(15'000'000, 'x'), 1000).size(), 1100u);
}

TEST(Shortened, LinesStayAndTheRestIsUtf8) {
  EXPECT_EQ(shortened("a\nb\xff", 1000), "a\nb?");
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc... (1 more bytes)");
}

TEST(FewNames, AreAllThatThereAre) {
  EXPECT_EQ(few_names({}), "");
  EXPECT_EQ(few_names(std::vector<std::string>{"a.png"}), "a.png");
  EXPECT_EQ(few_names(std::vector<std::string>{"a", "b", "c", "d", "e"}), "a, b, c, d, e");
}

TEST(FewNames, OfManySayHowManyMoreThereAre) {
  const std::vector<std::string> names(20'000, "a");
  EXPECT_EQ(few_names(names), "a, a, a, a, a and 19995 more");
}

TEST(FewNames, AreSafeOnATerminalAndShort) {
  EXPECT_EQ(few_names(std::vector<std::string>{"a\x1b[31m", "b\nc"}), "a?[31m, b?c");
  EXPECT_LT(few_names(std::vector<std::string>(9, std::string(1'000'000, 'x'))).size(), 1000u);
}

TEST(CheckName, RefusesWhatIsNotUtf8AndWhatIsNotShownAsItStands) {
  EXPECT_TRUE(check_name("it", "M\xc3\xbcller \xe2\x80\x94 5").is_ok());
  EXPECT_EQ(check_name("the user's name", "M\xfcller").message(),
            "the user's name is not valid UTF-8");
  for (const char* name : {"a\nb", "a\x7f", "a\xc2\x85", "a\xc2\x9b", "a\xe2\x80\xae"})
    EXPECT_EQ(check_name("it", name).message(), "it has control characters");
  EXPECT_EQ(check_name("it", "").message(), "it is empty");
  EXPECT_EQ(check_name("it", std::string(201, 'a')).message(),
            "it has 201 bytes, the limit is 200");
  EXPECT_TRUE(check_name("it", std::string(200, 'a')).is_ok());
}

TEST(NameLike, IsTheNameOfAFileWithoutWhatIsRefused) {
  EXPECT_EQ(name_like("M\xc3\xbcller \xe2\x80\x94 5"), "M\xc3\xbcller \xe2\x80\x94 5");
  EXPECT_EQ(name_like("\xe2\x80\x8f\xd7\xa9\xe2\x80\x8e 1\n"), "\xd7\xa9 1")
      << "marks of direction";
  EXPECT_EQ(name_like("M\xfcller"), "M?ller");
  EXPECT_EQ(name_like("\x01"), "scan");
  EXPECT_EQ(name_like(std::string(199, 'a') + "\xc3\xbc"), std::string(199, 'a'));
  for (const char* name : {"", "\xff", "a\tb"})
    EXPECT_TRUE(check_name("it", name_like(name)).is_ok()) << name;
}

TEST(SecondsText, HasAsManyDigitsAsItNeeds) {
  EXPECT_EQ(seconds_text(std::chrono::milliseconds(10'000)), "10 s");
  EXPECT_EQ(seconds_text(std::chrono::milliseconds(250)), "0.25 s");
}

}  // namespace
}  // namespace burnish
