#include "server/session/history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class HistoryTest : public testing::Test {
 protected:
  Result<uint64_t> apply(const std::string& author, decltype(Edit::change) change) {
    return history_.apply({author, 0, {std::to_string(++last_id_), std::move(change)}});
  }
  uint64_t edit(const std::string& author) { return apply(author, SetGradientScale{}).value(); }
  uint64_t undo(const std::string& author) { return apply(author, Undo{}).value(); }
  uint64_t redo(const std::string& author) { return apply(author, Redo{}).value(); }

  /// Returns the numbers of the entries that are on.
  std::vector<uint64_t> enabled() const {
    std::vector<uint64_t> numbers;
    for (const auto& entry : history_.entries())
      if (entry.enabled) numbers.push_back(entry.number);
    return numbers;
  }

  History history_;
  int last_id_ = 0;
};

TEST_F(HistoryTest, UndoAndRedoGoBackAndForthWithoutEnd) {
  for (int i = 0; i < 3; ++i) edit("ann");
  EXPECT_EQ(undo("ann"), 3u);
  EXPECT_EQ(undo("ann"), 2u);
  EXPECT_EQ(undo("ann"), 1u);
  EXPECT_EQ(apply("ann", Undo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(redo("ann"), 1u);
  EXPECT_EQ(redo("ann"), 2u);
  EXPECT_EQ(undo("ann"), 2u);
  EXPECT_EQ(redo("ann"), 2u);
  EXPECT_EQ(redo("ann"), 3u);
  EXPECT_EQ(apply("ann", Redo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(enabled(), ElementsAre(1, 2, 3));
}

TEST_F(HistoryTest, EachUndoesOnlyTheirOwn) {
  edit("ann");
  edit("bob");
  EXPECT_EQ(undo("ann"), 1u);
  EXPECT_EQ(apply("ann", Undo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(apply("bob", Redo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(enabled(), ElementsAre(2));
}

TEST_F(HistoryTest, ANewEditEndsItsAuthorsRedoAndNoOneElses) {
  edit("ann");
  edit("bob");
  undo("ann");
  undo("bob");
  edit("ann");
  EXPECT_EQ(apply("ann", Redo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(redo("bob"), 2u);
}

TEST_F(HistoryTest, AnyEntryIsSwitchedOffAndOnByAnybody) {
  edit("ann");
  edit("ann");
  EXPECT_EQ(apply("bob", SwitchEntry{1, false}).value(), 1u);
  EXPECT_THAT(enabled(), ElementsAre(2));
  EXPECT_EQ(undo("ann"), 2u);
  EXPECT_EQ(apply("ann", Undo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(apply("bob", SwitchEntry{1, true}).value(), 1u);
  EXPECT_EQ(apply("bob", SwitchEntry{2, true}).value(), 2u);
  EXPECT_EQ(apply("ann", Redo{}).status().code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(enabled(), ElementsAre(1, 2));
  EXPECT_EQ(apply("bob", SwitchEntry{9, true}).status().code(), StatusCode::kNotFound);
}

TEST_F(HistoryTest, ARestoredCheckpointSwitchesEverythingToWhatItWas) {
  edit("ann");  // 1
  edit("bob");  // 2
  undo("ann");  // 3
  EXPECT_EQ(apply("bob", SetCheckpoint{"x"}).value(), 4u);
  redo("ann");  // 5
  undo("bob");  // 6
  edit("ann");  // 7
  ASSERT_TRUE(apply("ann", RestoreCheckpoint{"x"}).is_ok());
  EXPECT_THAT(enabled(), ElementsAre(2, 4));
  EXPECT_EQ(apply("ann", RestoreCheckpoint{"y"}).status().code(), StatusCode::kNotFound);
  EXPECT_THAT(apply("ann", SwitchEntry{4, false}).status().message(), HasSubstr("checkpoint"));
}

TEST_F(HistoryTest, ACheckpointsNameMeansItsLastUse) {
  apply("ann", SetCheckpoint{"x"}).value();
  edit("ann");
  apply("ann", SetCheckpoint{"x"}).value();
  edit("ann");
  EXPECT_EQ(history_.checkpoint("x").value(), 3u);
  ASSERT_TRUE(apply("ann", RestoreCheckpoint{"x"}).is_ok());
  EXPECT_THAT(enabled(), ElementsAre(1, 2, 3));
}

TEST_F(HistoryTest, IdsAreEachAuthorsOwn) {
  ASSERT_TRUE(history_.apply({"ann", 0, {"x", SetGradientScale{}}}).is_ok());
  EXPECT_TRUE(history_.knows("ann", "x"));
  EXPECT_FALSE(history_.knows("bob", "x"));
}

TEST_F(HistoryTest, CountsTheBytesOfItsEditsAndNoneOfThoseTakenBack) {
  EXPECT_EQ(history_.byte_count(), 0u);
  SetCellFields cells;
  cells.cells.resize(1000);
  ASSERT_TRUE(apply("ann", cells).is_ok());
  EXPECT_GE(history_.byte_count(), 1000 * sizeof(SetCellFields::Cell));
  const uint64_t before = history_.byte_count();
  ASSERT_TRUE(apply("ann", Stroke{{}, std::vector<Vec3d>(500)}).is_ok());
  EXPECT_GE(history_.byte_count(), before + 500 * sizeof(Vec3d));
  history_.take_back();
  EXPECT_EQ(history_.byte_count(), before);
}

TEST_F(HistoryTest, WhatIsTakenBackLeavesNoTrace) {
  edit("ann");
  edit("bob");
  undo("ann");
  const std::vector<decltype(Edit::change)> changes = {SetGradientScale{}, Redo{},
                                                       SwitchEntry{2, false}, SetCheckpoint{"x"}};
  for (const auto& change : changes) {
    apply("ann", change).value();
    history_.take_back();
    EXPECT_EQ(history_.size(), 3u);
    EXPECT_THAT(enabled(), ElementsAre(2));
    EXPECT_FALSE(history_.checkpoint("x").is_ok());
    EXPECT_FALSE(history_.knows("ann", std::to_string(last_id_)));
  }
  apply("bob", Undo{}).value();
  history_.take_back();
  EXPECT_EQ(redo("ann"), 1u);
  EXPECT_EQ(undo("bob"), 2u);
}

TEST_F(HistoryTest, ADamagedEntryKeepsItsNumberAndStaysOff) {
  edit("ann");
  EXPECT_FALSE(history_.restore({"ann", 0, {"", Damaged{"a hole"}}}));
  EXPECT_EQ(edit("ann"), 3u);
  EXPECT_FALSE(history_.entries()[1].is_on());
  EXPECT_TRUE(history_.entries()[2].is_on());
  const Status status = apply("bob", SwitchEntry{2, true}).status();
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("entry 2 is damaged"));
}

TEST_F(HistoryTest, WhatUndidADamagedEntryUndoesNothingElse) {
  edit("ann");
  history_.restore({"ann", 0, {"", Damaged{"a hole"}}});
  EXPECT_TRUE(history_.restore({"ann", 0, {"u", Undo{}}}));
  EXPECT_TRUE(history_.restore({"bob", 0, {"s", SwitchEntry{2, true}}}));
  EXPECT_TRUE(history_.entries()[0].is_on());
  EXPECT_FALSE(history_.entries()[1].is_on());
}

TEST_F(HistoryTest, WhatNeededADamagedEditHasNoEffect) {
  edit("ann");
  history_.restore({"ann", 0, {"", Damaged{"was an undo"}}});
  EXPECT_FALSE(history_.restore({"ann", 0, {"r", Redo{}}}));
  EXPECT_FALSE(history_.restore({"ann", 0, {"c", RestoreCheckpoint{"gone"}}}));
  EXPECT_EQ(history_.size(), 4u);
  EXPECT_TRUE(history_.knows("ann", "r"));
  EXPECT_EQ(edit("ann"), 5u);
  EXPECT_TRUE(history_.entries()[0].is_on());
}

}  // namespace
}  // namespace burnish
