#include <future>
#include <latch>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/wire/edit_bytes.h"
#include "server/journal/sqlite_journal.h"
#include "tests/server/journal/journal_place.h"

namespace burnish {
namespace {

using testing::HasSubstr;

SessionRecord record(const std::string& name) {
  return {"id-" + name, name, std::string(64, 'a'), {7, 0.5}, 1234};
}

std::vector<AuthoredEdit> some_edits() {
  return {{"ann", 1, {"1", SetGradientScale{0.5}}},
          {"bob", 2, {"1", SetTransferCurve{TransferCurve(20)}}},
          {"", 3, {"3", Stroke{{.radius = 1, .beta = 2, .connected = true}, {Vec3d(1, 2, 3)}}}},
          {"ann", 4, {"4", Undo{}}}};
}

AuthoredEdit slider(const std::string& id) {
  return {"ann", 0, {id, SetGradientScale{0.5}}};
}

/// A journal of each kind, with the session "a".
class JournalTest : public testing::TestWithParam<JournalKind> {
 protected:
  JournalTest() {
    start();
    EXPECT_TRUE(journal_->create_session(record("a"), {}).is_ok());
  }

  /// Like a new program, which holds all sessions.
  void start() {
    journal_.reset();
    journal_ = place_.open();
    const std::vector<SessionRecord> sessions = journal_->sessions().value();
    for (const SessionRecord& session : sessions) EXPECT_TRUE(journal_->hold(session.id).is_ok());
  }

  JournalPlace place_{GetParam()};
  std::unique_ptr<Journal> journal_;
};

INSTANTIATE_TEST_SUITE_P(Kinds, JournalTest, testing::ValuesIn(kJournalKinds), name_of_kind);

TEST_P(JournalTest, SessionsAndEditsComeBackFromANewProgram) {
  ASSERT_TRUE(journal_->create_session(record("b"), {}).is_ok());
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_on_disk());
  start();
  const auto sessions = journal_->sessions().value();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].name, "a");
  EXPECT_EQ(sessions[0].key, (PreparedKey{7, 0.5}));
  EXPECT_EQ(sessions[0].created_unix_seconds, 1234);
  const auto edits = journal_->edits("id-a").value();
  ASSERT_EQ(edits.size(), 4u);
  for (size_t i = 0; i < edits.size(); ++i) {
    EXPECT_EQ(edits[i].author, some_edits()[i].author);
    EXPECT_EQ(edits[i].unix_ms, some_edits()[i].unix_ms);
    EXPECT_EQ(edit_to_bytes(edits[i].edit), edit_to_bytes(some_edits()[i].edit));
  }
  EXPECT_EQ(journal_->edit_count("id-a").value(), 4u);
  EXPECT_EQ(journal_->edit_count("id-b").value(), 0u);
}

TEST_P(JournalTest, ASessionKeepsTheControlsThatItWasBornWith) {
  SessionRecord pinned = record("b");
  pinned.controls.pin_rims = true;
  ASSERT_TRUE(journal_->create_session(pinned, {}).is_ok());
  ASSERT_TRUE(journal_->rename_session("id-b", "c").is_ok());
  start();
  const auto sessions = journal_->sessions().value();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_FALSE(sessions[0].controls.pin_rims);
  EXPECT_TRUE(sessions[1].controls.pin_rims);
  EXPECT_FALSE(sessions[1].is_damaged);
}

TEST_P(JournalTest, ASessionKeepsItsMakerUnderANewNameAndForTheNextProgram) {
  SessionRecord made = record("b"), by_nobody = record("n");
  made.maker = "ann";
  by_nobody.maker = "";
  ASSERT_TRUE(journal_->create_session(made, SessionRoles::of_new_session("bob")).is_ok());
  ASSERT_TRUE(journal_->create_session(by_nobody, {}).is_ok());
  ASSERT_TRUE(journal_->rename_session("id-b", "c").is_ok());
  start();
  const auto sessions = journal_->sessions().value();
  ASSERT_EQ(sessions.size(), 3u);
  EXPECT_EQ(sessions[0].maker, std::nullopt) << "its record did not say";
  EXPECT_EQ(sessions[1].maker, "ann");
  EXPECT_EQ(sessions[2].maker, "");
}

TEST_P(JournalTest, AForkHasAMakerOfItsOwn) {
  SessionRecord source = record("b"), fork = record("f");
  source.maker = "ann";
  fork.maker = "bob";
  ASSERT_TRUE(journal_->create_session(source, {}).is_ok());
  ASSERT_TRUE(journal_->fork_session(source, 0, fork, {}).is_ok());
  EXPECT_EQ(journal_->sessions().value()[1].maker, "ann");
  EXPECT_EQ(journal_->sessions().value()[2].maker, "bob");
}

TEST_P(JournalTest, ABatchWithAKnownIdIsKeptOutWhole) {
  ASSERT_TRUE(journal_->append("id-a", 1, {slider("x")}).is_on_disk());
  EXPECT_EQ(journal_->append("id-a", 2, {slider("y"), slider("x")}).status().code(),
            StatusCode::kAlreadyExists);
  EXPECT_EQ(journal_->edit_count("id-a").value(), 1u);
}

TEST_P(JournalTest, EditsBehindOneThatWasLostAreRefused) {
  ASSERT_TRUE(journal_->append("id-a", 1, {slider("x")}).is_on_disk());
  EXPECT_EQ(journal_->append("id-a", 3, {slider("z")}).status().code(), StatusCode::kDataLoss);
  EXPECT_EQ(journal_->append("id-a", 3, {}).status().code(), StatusCode::kDataLoss);
  EXPECT_TRUE(journal_->append("id-a", 2, {}).is_on_disk());
}

TEST_P(JournalTest, EditsThatComeWhileACommitIsUnderWayShareTheNextOne) {
  constexpr int kEdits = 20;
  std::latch first_is_written(1), go_on(1), all_are_written(kEdits);
  journal_->append("id-a", 1, {slider("0")}, [&](const WriteOutcome&) {
    first_is_written.count_down();
    go_on.wait();
  });
  first_is_written.wait();
  const uint64_t commits = journal_->commits();
  for (int i = 1; i <= kEdits; ++i)
    journal_->append("id-a", static_cast<uint64_t>(i + 1), {slider(std::to_string(i))},
                     [&](const WriteOutcome& outcome) {
                       EXPECT_TRUE(outcome.is_on_disk()) << outcome.status().message();
                       all_are_written.count_down();
                     });
  go_on.count_down();
  all_are_written.wait();
  EXPECT_EQ(journal_->commits(), commits + 1);
}

TEST_P(JournalTest, AFailureDoesNotTouchTheOthersOfItsCommit) {
  std::latch first_is_written(1), go_on(1);
  std::promise<Status> good, bad;
  journal_->append("id-a", 1, {slider("0")}, [&](const WriteOutcome&) {
    first_is_written.count_down();
    go_on.wait();
  });
  first_is_written.wait();
  journal_->append("nobody", 1, {slider("1")},
                   [&](const WriteOutcome& o) { bad.set_value(o.status()); });
  journal_->append("id-a", 2, {slider("1")},
                   [&](const WriteOutcome& o) { good.set_value(o.status()); });
  go_on.count_down();
  EXPECT_FALSE(bad.get_future().get().is_ok());
  EXPECT_TRUE(good.get_future().get().is_ok());
  EXPECT_EQ(journal_->edit_count("id-a").value(), 2u);
}

TEST_P(JournalTest, RemovingASessionForgetsItsEdits) {
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_on_disk());
  ASSERT_TRUE(journal_->remove_session("id-a").is_ok());
  EXPECT_TRUE(journal_->sessions().value().empty());
  EXPECT_TRUE(journal_->edits("id-a").value().empty());
}

TEST_P(JournalTest, ASessionWithANameThatIsTakenIsRefused) {
  SessionRecord other = record("b");
  other.name = "a";
  EXPECT_EQ(journal_->create_session(other, {}).code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(journal_->sessions().value().size(), 1u);
}

TEST_P(JournalTest, ARenamedSessionKeepsItsEdits) {
  ASSERT_TRUE(journal_->create_session(record("b"), {}).is_ok());
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_on_disk());
  EXPECT_EQ(journal_->rename_session("id-a", "b").code(), StatusCode::kAlreadyExists);
  ASSERT_TRUE(journal_->rename_session("id-a", "c").is_ok());
  EXPECT_EQ(journal_->rename_session("nobody", "d").code(), StatusCode::kNotFound);
  start();
  EXPECT_EQ(journal_->sessions().value()[1].name, "c");
  EXPECT_EQ(journal_->edit_count("id-a").value(), 4u);
}

TEST_P(JournalTest, ALongHistoryComesBackInOrder) {
  std::vector<AuthoredEdit> many;
  for (int i = 0; i < 1000; ++i) many.push_back(slider("s" + std::to_string(i)));
  ASSERT_TRUE(journal_->append("id-a", 1, many).is_on_disk());
  const auto edits = journal_->edits("id-a").value();
  ASSERT_EQ(edits.size(), many.size());
  for (size_t i = 0; i < many.size(); ++i) EXPECT_EQ(edits[i].edit.id, many[i].edit.id);
}

TEST_P(JournalTest, EditsOfNoSessionAreRefused) {
  EXPECT_FALSE(journal_->append("nobody", 1, some_edits()).is_on_disk());
}

TEST_P(JournalTest, AForkHasTheFirstEditsOfItsSource) {
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_on_disk());
  ASSERT_TRUE(journal_->fork_session(record("a"), 2, record("f"), {}).is_ok());
  EXPECT_EQ(journal_->edit_count("id-f").value(), 2u);
  EXPECT_EQ(journal_->edits("id-f").value()[1].author, "bob");
  EXPECT_EQ(journal_->fork_session(record("a"), 5, record("g"), {}).status().code(),
            StatusCode::kDataLoss);
  EXPECT_EQ(journal_->sessions().value().size(), 2u);
}

TEST_P(JournalTest, AForkAtAnotherDepthHasNoCellFieldsAndNoPaint) {
  const SetCellFields cells{{{Vec3i(1, 2, 3), 1, 1, 1}}};
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_on_disk());
  const uint64_t count = journal_->edit_count("id-a").value();
  ASSERT_TRUE(journal_->append("id-a", count + 1, {{"ann", 0, {"cells", cells}}}).is_on_disk());
  journal_->keep_paint("id-a", {101, 1, {{1, 3}, {0.5f, 2}, {1, 0.25f}}});
  SessionRecord deeper = record("f");
  ++deeper.key.depth;
  EXPECT_EQ(journal_->fork_session(record("a"), count + 1, deeper, {}).value(), 1u);
  EXPECT_EQ(journal_->fork_session(record("a"), count + 1, record("g"), {}).value(), 0u);
  const auto fields = [&](const std::string& id) {
    return std::get<SetCellFields>(journal_->edits(id).value().back().edit.change).cells.size();
  };
  EXPECT_EQ(fields("id-f"), 0u);
  EXPECT_EQ(fields("id-g"), 1u);
  EXPECT_EQ(journal_->paint("id-f", 4).value().size(), 0u);
  EXPECT_EQ(journal_->paint("id-g", 4).value().size(), 1u);
  EXPECT_EQ(journal_->edits("id-f").value()[0].edit.id, some_edits()[0].edit.id);
}

TEST_P(JournalTest, RolesComeBackFromANewProgram) {
  ASSERT_TRUE(journal_->create_session(record("b"), SessionRoles::of_new_session("ann")).is_ok());
  ASSERT_TRUE(journal_->set_role("id-b", "bob", SessionRole::kViewer).is_ok());
  start();
  EXPECT_EQ(journal_->roles("id-b").value().of("ann"), SessionRole::kOwner);
  EXPECT_EQ(journal_->roles("id-b").value().of("bob"), SessionRole::kViewer);
  EXPECT_EQ(journal_->roles("id-b").value().of("eve"), SessionRole::kEditor);
  EXPECT_EQ(journal_->roles("id-a").value().of("eve"), SessionRole::kOwner);
}

TEST_P(JournalTest, OfPaintTheNewestIsKept) {
  for (uint64_t strokes = 1; strokes <= 10; ++strokes)
    journal_->keep_paint("id-a", {100 + strokes, strokes, {{1, 3}, {0.5f, 2}, {1, 0.25f}}});
  const auto kept = journal_->paint("id-a", 4).value();
  ASSERT_EQ(kept.size(), 8u);
  EXPECT_EQ(kept.back().series, 110u);
  EXPECT_EQ(kept.back().strokes, 10u);
  EXPECT_EQ(kept.back().painted.value, (std::vector<float>{0.5f, 2}));
  EXPECT_TRUE(journal_->paint("id-a", 3).value().empty());  // for another mesh
}

}  // namespace
}  // namespace burnish
