#include "client/model/input/bindings.h"

#include <set>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Bindings, EveryActionHasAKeyOfItsOwn) {
  const Bindings bindings;
  std::set<std::string> keys;
  for (const ActionInfo& info : actions()) {
    EXPECT_TRUE(keys.insert(bindings.key_of(info.action)).second) << info.name;
    EXPECT_EQ(bindings.action_of(bindings.key_of(info.action)), info.action);
  }
}

TEST(Bindings, AKeyCanBeGivenToAnAction) {
  Bindings bindings;
  ASSERT_TRUE(bindings.bind("undo", "Ctrl+U").is_ok());
  EXPECT_EQ(bindings.action_of("Ctrl+U"), Action::kUndo);
  EXPECT_FALSE(bindings.action_of("Ctrl+Z").has_value());
}

TEST(Bindings, TheSecondKeyOfAnActionCanBeGivenToAnother) {
  Bindings bindings;
  EXPECT_EQ(bindings.action_of("Ctrl+Y"), Action::kRedo);
  ASSERT_TRUE(bindings.bind("split", "Ctrl+Y").is_ok());
  EXPECT_EQ(bindings.action_of("Ctrl+Y"), Action::kSplit);
  EXPECT_FALSE(bindings.action_of("").has_value());
}

TEST(Bindings, AllKeysOfAnActionAreListedAsLongAsTheyAreItsOwn) {
  Bindings bindings;
  EXPECT_EQ(bindings.keys_of(Action::kUndo), "Ctrl+Z");
  EXPECT_EQ(bindings.keys_of(Action::kRedo), "Ctrl+Shift+Z, Ctrl+Y");
  ASSERT_TRUE(bindings.bind("split", "Ctrl+Y").is_ok());
  EXPECT_EQ(bindings.keys_of(Action::kRedo), "Ctrl+Shift+Z");
}

TEST(Bindings, UnknownActionsAndTakenKeysAreRefused) {
  Bindings bindings;
  EXPECT_EQ(bindings.bind("polish", "P").message(), "keys: unknown action 'polish'");
  EXPECT_EQ(bindings.bind("undo", "Home").code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(bindings.key_of(Action::kUndo), "Ctrl+Z");
}

}  // namespace
}  // namespace burnish
