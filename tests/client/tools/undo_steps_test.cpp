#include "client/tools/undo_steps.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(UndoSteps, AnUnknownStepHasOneEdit) {
  UndoSteps steps;
  EXPECT_EQ(steps.undo(), 1);
  EXPECT_EQ(steps.redo(), 1);
}

TEST(UndoSteps, JoinedEditsAreUndoneAndRedoneTogetherHoweverLongAgo) {
  UndoSteps steps;
  steps.add();
  steps.add();
  steps.join_last_two();
  steps.add();
  EXPECT_EQ(steps.undo(), 1);
  EXPECT_EQ(steps.undo(), 2);
  EXPECT_EQ(steps.redo(), 2);
  EXPECT_EQ(steps.redo(), 1);
}

TEST(UndoSteps, RedoNamesTheStepThatWasTakenBackLast) {
  UndoSteps steps;
  steps.add();
  EXPECT_EQ(steps.next_undo(), 1);
  EXPECT_EQ(steps.redo_name(), "");
  steps.undo("Smooth stroke");
  steps.undo("Limits");
  EXPECT_EQ(steps.redo_name(), "Limits");
  steps.redo();
  EXPECT_EQ(steps.redo_name(), "Smooth stroke");
  steps.add();
  EXPECT_EQ(steps.redo_name(), "");
}

TEST(UndoSteps, ANewEditLeavesNothingToRedo) {
  UndoSteps steps;
  steps.add();
  steps.add();
  steps.join_last_two();
  EXPECT_EQ(steps.undo(), 2);
  steps.add();
  EXPECT_EQ(steps.redo(), 1);
}

TEST(UndoSteps, ForgottenStepsHaveOneEdit) {
  UndoSteps steps;
  steps.add();
  steps.add();
  steps.join_last_two();
  steps.clear();
  EXPECT_EQ(steps.undo(), 1);
}

}  // namespace
}  // namespace burnish
