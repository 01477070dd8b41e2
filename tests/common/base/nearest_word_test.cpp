#include "common/base/nearest_word.h"

#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

const std::vector<std::string> kCommands = {"edit", "export", "filter", "import"};

TEST(NearestWord, IsAFewLettersAway) {
  EXPECT_EQ(nearest_word("exprt", kCommands), "export");
  EXPECT_EQ(nearest_word("filtre", kCommands), "filter");
  EXPECT_EQ(nearest_word("edits", kCommands), "edit");
  EXPECT_EQ(nearest_word("export", kCommands), "export");
}

TEST(NearestWord, IsNothingForAnotherWord) {
  EXPECT_EQ(nearest_word("paint", kCommands), "");
  EXPECT_EQ(nearest_word("", kCommands), "");
  EXPECT_EQ(nearest_word("edit", {}), "");
  EXPECT_EQ(nearest_word(std::string(1000000, 'e'), kCommands), "");
}

TEST(NearestWord, IsAskedForAtTheEndOfAMessage) {
  EXPECT_EQ(did_you_mean("exprt", kCommands), "; did you mean 'export'?");
  EXPECT_EQ(did_you_mean("paint", kCommands), "");
}

}  // namespace
}  // namespace burnish
