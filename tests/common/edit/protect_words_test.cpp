#include "common/edit/protect_words.h"

#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<std::string> split(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

TEST(ProtectWords, ComeBackUnchanged) {
  for (const char* line :
       {"curvature -20 0.5", "release piece 1 2 -3", "grow 4", "shrink 64", "invert", "clear",
        "lasso 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 -0.5 0 0.5 0 0 1",
        "release through 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 -0.5 0 0.5 0 0 1"}) {
    const auto change = parse_protect(split(line));
    ASSERT_TRUE(change.is_ok()) << line << ": " << change.status().message();
    EXPECT_EQ(to_words(*change), line);
  }
}

TEST(ProtectWords, NameWhatIsWrong) {
  const auto refusal = [](const std::string& line) {
    const auto change = parse_protect(split(line));
    return change.is_ok() ? "accepted" : change.status().message();
  };
  EXPECT_THAT(refusal(""), HasSubstr("curvature"));
  EXPECT_THAT(refusal("everything"), HasSubstr("everything"));
  EXPECT_THAT(refusal("curvature 3"), HasSubstr("1 numbers, not 2"));
  EXPECT_THAT(refusal("curvature 3 2"), HasSubstr("3 to 2"));
  EXPECT_THAT(refusal("curvature 3 x"), HasSubstr("x"));
  EXPECT_THAT(refusal("grow 65"), HasSubstr("65"));
  EXPECT_THAT(refusal("grow 0"), HasSubstr("64"));
  EXPECT_THAT(refusal("lasso 1 2 3"), HasSubstr("3 numbers, not 16"));
  EXPECT_THAT(refusal("lasso 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0 0"), HasSubstr("1 points"));
}

TEST(ProtectWords, SummariesAreShort) {
  EXPECT_EQ(summary(*parse_protect(split("release piece 1 2 3"))), "release piece");
  EXPECT_EQ(summary(*parse_protect(split("shrink 2"))), "protect: shrink by 2");
  EXPECT_EQ(summary(*parse_protect(split("curvature -1 20"))), "protect curvature -1 to 20");
}

}  // namespace
}  // namespace burnish
