#include "server/library/kept_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(KeptName, BlanksAtTheEndsAndUnseenCharactersAreRefused) {
  for (const char* name : {" ", "   ", "open ", " open", "open\u00a0", "\u3000", "open\u200b",
                           "\ufeffopen", "o\u00adpen", "op\u2060en", "\u200d", "o\U000e0002pen"})
    EXPECT_EQ(check_kept_name("the name", name).code(), StatusCode::kInvalidArgument) << name;
  for (const char* name : {"open", "left hand", "Müller", "猫", "k\u200cy", "face", "a.b (2)"})
    EXPECT_TRUE(check_kept_name("the name", name).is_ok()) << name;
}

TEST(KeptName, AScansNameIsNotTheBeginningOfAnId) {
  for (const std::string& name : {std::string("face"), std::string("DEAD"), std::string("2024"),
                                  std::string(12, 'a'), std::string(64, '0')})
    EXPECT_THAT(check_scan_name(name).message(), HasSubstr("hexadecimal")) << name;
  for (const std::string& name :
       {std::string("abc"), std::string("faces"), std::string("2024-1"), std::string(65, '0')})
    EXPECT_TRUE(check_scan_name(name).is_ok()) << name;
}

TEST(KeptName, NamesThatLookAlikeHaveOneLook) {
  EXPECT_EQ(look_of_name("Open"), look_of_name("open"));
  EXPECT_EQ(look_of_name("ÄRGER"), look_of_name("ärger"));
  EXPECT_EQ(look_of_name("ЖУК"), look_of_name("жук"));
  EXPECT_EQ(look_of_name("ΑΒΓ"), look_of_name("αβγ"));
  EXPECT_EQ(look_of_name("Ｏpen"), look_of_name("open"));
  EXPECT_EQ(look_of_name("op\u200den"), look_of_name("open"));
  EXPECT_EQ(look_of_name("a\u00a0b"), look_of_name("a b"));
  EXPECT_EQ(look_of_name("M\u00fcller"), look_of_name("Mu\u0308ller")) << "two ways to write ü";
  EXPECT_EQ(look_of_name("Straße"), look_of_name("STRASSE"));
  EXPECT_EQ(look_of_name("ﬁgure"), look_of_name("figure"));
  EXPECT_EQ(look_of_name("ᏸ"), look_of_name("Ᏸ"));
  EXPECT_EQ(look_of_name("a\U000e0100b"), look_of_name("ab"));
  EXPECT_NE(look_of_name("open"), look_of_name("opens"));
  EXPECT_NE(look_of_name("a b"), look_of_name("ab"));
  EXPECT_EQ(look_of_name("猫𝄞"), "猫𝄞");
}

TEST(KeptName, NumberedNamesAreAlwaysNames) {
  EXPECT_EQ(numbered_scan_name("scan", 1), "scan");
  EXPECT_EQ(numbered_scan_name("scan", 2), "scan (2)");
  EXPECT_EQ(numbered_scan_name("face", 1), "face (1)");
  EXPECT_EQ(numbered_scan_name(" a\u200b b ", 1), "a b");
  EXPECT_EQ(numbered_scan_name(" \u200b ", 1), "scan");
  for (const std::string& name :
       {std::string(200, 'a'), std::string(199, 'x') + "ä", std::string(), std::string("\u200d")})
    for (int number : {1, 2, 100})
      EXPECT_TRUE(check_scan_name(numbered_scan_name(name, number)).is_ok()) << name;
}

}  // namespace
}  // namespace burnish
