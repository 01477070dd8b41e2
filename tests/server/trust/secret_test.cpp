#include "server/trust/secret.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Secret, EachIsAnother) {
  const std::string one = make_secret(), two = make_secret();
  EXPECT_THAT(one, testing::MatchesRegex("[0-9a-f]{64}"));
  EXPECT_NE(one, two);
}

TEST(Secret, OnlyTheSameTextIsTheSame) {
  EXPECT_TRUE(is_same_secret("abc", "abc"));
  EXPECT_FALSE(is_same_secret("abc", "abd"));
  EXPECT_FALSE(is_same_secret("abc", "ab"));
  EXPECT_FALSE(is_same_secret("", ""));
}

}  // namespace
}  // namespace burnish
