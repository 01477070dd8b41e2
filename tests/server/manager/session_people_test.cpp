// Several people at one session: authors, undo, roles, forks.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "server/manager/session_manager.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// A session "work" that ann has opened.
class SessionPeopleTest : public testing::Test {
 protected:
  SessionPeopleTest() {
    EXPECT_TRUE(library_.import(sphere_file(1, 2), "ball", {}, 4).is_ok());
    start();
    EXPECT_TRUE(manager_->open({"ball", "work", {4, 0}}, "ann", {}).is_ok());
  }

  void start() {
    manager_.reset();
    journal_.reset();
    library_.restart();
    journal_ = std::move(SqliteJournal::open(library_.folder->journal())).value();
    SessionManagerOptions options;
    options.solver.threads = 1;
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
            .value();
  }

  Result<ApplyOutcome> apply(const std::string& user, decltype(Edit::change) change,
                             const std::string& session = "work") {
    const Edit edit{"e" + std::to_string(++last_id_), std::move(change)};
    return manager_->apply(session, user, {&edit, 1}, {});
  }

  double beta(const std::string& session = "work") {
    return manager_->state(session, {}).value().settings.beta;
  }

  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  int last_id_ = 0;
};

TEST_F(SessionPeopleTest, UndoOfEachUserSurvivesARestart) {
  ASSERT_TRUE(apply("ann", SetGradientScale{0.25}).is_ok());
  ASSERT_TRUE(apply("bob", SetGradientScale{0.5}).is_ok());
  ASSERT_TRUE(apply("bob", Undo{}).is_ok());
  start();
  EXPECT_EQ(beta(), 0.25);
  EXPECT_EQ(apply("bob", Redo{}).value().entries, (std::vector<uint64_t>{2}));
  EXPECT_EQ(beta(), 0.5);
  EXPECT_EQ(apply("ann", Undo{}).value().entries, (std::vector<uint64_t>{1}));
  EXPECT_EQ(beta(), 0.5);
  EXPECT_EQ(apply("ann", Undo{}).status().code(), StatusCode::kFailedPrecondition);
}

TEST_F(SessionPeopleTest, AnUndoSentTwiceUndoesOnce) {
  ASSERT_TRUE(apply("ann", SetGradientScale{0.25}).is_ok());
  ASSERT_TRUE(apply("ann", SetGradientScale{0.5}).is_ok());
  const Edit undo{"again", Undo{}};
  EXPECT_EQ(manager_->apply("work", "ann", {&undo, 1}, {}).value().applied, 1u);
  EXPECT_EQ(manager_->apply("work", "ann", {&undo, 1}, {}).value().known, 1u);
  EXPECT_EQ(beta(), 0.25);
}

TEST_F(SessionPeopleTest, TheSameIdOfTwoUsersIsTwoEdits) {
  const Edit edit{"1", SetGradientScale{0.5}};
  EXPECT_EQ(manager_->apply("work", "ann", {&edit, 1}, {}).value().applied, 1u);
  EXPECT_EQ(manager_->apply("work", "bob", {&edit, 1}, {}).value().applied, 1u);
}

TEST_F(SessionPeopleTest, AViewersEditIsRefusedAndChangesNothing) {
  ASSERT_TRUE(manager_->set_role("work", "ann", "bob", SessionRole::kViewer, {}).is_ok());
  const Status refused = apply("bob", SetGradientScale{0.5}).status();
  EXPECT_EQ(refused.code(), StatusCode::kPermissionDenied);
  EXPECT_THAT(refused.message(), HasSubstr("'bob' is viewer"));
  EXPECT_EQ(beta(), 1);
  start();
  EXPECT_EQ(apply("bob", SetGradientScale{0.5}).status().code(), StatusCode::kPermissionDenied);
  EXPECT_TRUE(apply("eve", SetGradientScale{0.5}).is_ok());
}

TEST_F(SessionPeopleTest, OnlyAnOwnerClosesTheSession) {
  const Status refused = manager_->close("work", "bob", {});
  EXPECT_EQ(refused.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(refused.message(),
            "closing the session needs the role owner; 'bob' is editor of this session");
  EXPECT_TRUE(manager_->list()[0].in_memory);
  EXPECT_TRUE(manager_->close("work", "ann", {}).is_ok());
  EXPECT_FALSE(manager_->list()[0].in_memory);
}

TEST_F(SessionPeopleTest, OnlyAnOwnerGivesRolesAndDeletes) {
  EXPECT_EQ(manager_->set_role("work", "bob", "bob", SessionRole::kOwner, {}).code(),
            StatusCode::kPermissionDenied);
  EXPECT_EQ(manager_->remove("work", "bob", {}).code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(manager_->set_role("work", "ann", "ann", SessionRole::kEditor, {}).code(),
            StatusCode::kFailedPrecondition);
  ASSERT_TRUE(manager_->set_role("work", "ann", "bob", SessionRole::kOwner, {}).is_ok());
  EXPECT_TRUE(manager_->set_role("work", "bob", "ann", SessionRole::kViewer, {}).is_ok());
  EXPECT_TRUE(manager_->remove("work", "bob", {}).is_ok());
}

/// Vera, who is a mere viewer on the server, and Otto, who owns it.
static Caller vera() {
  Caller caller("vera");
  caller.most = SessionRole::kViewer;
  return caller;
}
static Caller otto() {
  Caller caller("otto");
  caller.owns_server = true;
  return caller;
}

TEST_F(SessionPeopleTest, AViewerOfTheServerEditsNowhere) {
  const Edit edit{"1", SetGradientScale{0.5}};
  const Status refused = manager_->apply("work", vera(), {&edit, 1}).status();
  EXPECT_EQ(refused.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(refused.message(), "editing needs the role editor; 'vera' is viewer of this server");
  ASSERT_TRUE(manager_->set_role("work", "ann", "vera", SessionRole::kOwner).is_ok());
  EXPECT_FALSE(manager_->apply("work", vera(), {&edit, 1}).is_ok());
  EXPECT_FALSE(manager_->close("work", vera()).is_ok());
  EXPECT_FALSE(manager_->remove("work", vera()).is_ok());
}

TEST_F(SessionPeopleTest, TheServersOwnerIsOwnerEverywhere) {
  ASSERT_TRUE(manager_->set_role("work", "ann", "otto", SessionRole::kViewer).is_ok());
  EXPECT_TRUE(manager_->set_role("work", otto(), "bob", SessionRole::kOwner).is_ok());
  EXPECT_TRUE(manager_->close("work", otto()).is_ok());
  EXPECT_TRUE(manager_->remove("work", otto()).is_ok());
}

TEST_F(SessionPeopleTest, RolesAreForSoManyPeople) {
  for (size_t i = 2; i < kSessionRolesMax; ++i)
    ASSERT_TRUE(manager_->set_role("work", "ann", std::to_string(i), SessionRole::kViewer).is_ok());
  const Status refused = manager_->set_role("work", "ann", "one more", SessionRole::kViewer);
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.message(), HasSubstr("256"));
  EXPECT_TRUE(manager_->set_role("work", "ann", "5", SessionRole::kEditor).is_ok());
}

TEST_F(SessionPeopleTest, TheHistoryTellsWhoDidWhatAndIsReadInPages) {
  ASSERT_TRUE(apply("ann", SetGradientScale{0.25}).is_ok());
  ASSERT_TRUE(apply("bob", SetCheckpoint{"quarter"}).is_ok());
  ASSERT_TRUE(apply("bob", SetTransferCurve{TransferCurve(7)}).is_ok());
  ASSERT_TRUE(apply("bob", Undo{}).is_ok());
  const HistoryPage page = manager_->history({"work", 0, 2}, {}).value();
  ASSERT_EQ(page.entries.size(), 2u);
  EXPECT_FALSE(page.complete);
  EXPECT_EQ(page.entries[0].author, "ann");
  EXPECT_EQ(page.entries[0].summary, "beta 0.25");
  EXPECT_EQ(page.entries[1].kind, EditKind::kSetCheckpoint);
  EXPECT_EQ(page.entries[1].summary, "quarter");
  const HistoryPage rest = manager_->history({"work", 2, 10}, {}).value();
  ASSERT_EQ(rest.entries.size(), 1u);
  EXPECT_TRUE(rest.complete);
  EXPECT_EQ(rest.entries[0].number, 3u);
  EXPECT_FALSE(rest.entries[0].enabled);
  EXPECT_GT(rest.entries[0].unix_ms, 1'500'000'000'000);
}

TEST_F(SessionPeopleTest, AForkBeginsWhereItIsToldAndGoesItsOwnWay) {
  ASSERT_TRUE(apply("ann", SetGradientScale{0.25}).is_ok());
  ASSERT_TRUE(apply("ann", SetCheckpoint{"quarter"}).is_ok());
  ASSERT_TRUE(apply("ann", SetGradientScale{0.5}).is_ok());
  ASSERT_TRUE(manager_->fork({"work", "a", 0, "quarter"}, "bob", {}).is_ok());
  EXPECT_EQ(beta("a"), 0.25);
  EXPECT_EQ(manager_->fork({"work", "b", 1, ""}, "bob", {}).value().session.edits, 1u);
  EXPECT_EQ(manager_->fork({"work", "c", 0, ""}, "bob", {}).value().session.edits, 3u);
  EXPECT_EQ(beta("c"), 0.5);
  ASSERT_TRUE(apply("ann", Undo{}, "a").is_ok());
  EXPECT_EQ(beta("a"), 1);
  EXPECT_EQ(beta(), 0.5);
  EXPECT_EQ(manager_->people("a", {}).value().roles.of("bob"), SessionRole::kOwner);
  EXPECT_EQ(manager_->fork({"work", "a", 0, ""}, "bob", {}).status().code(),
            StatusCode::kAlreadyExists);
  EXPECT_EQ(manager_->fork({"work", "d", 4, ""}, "bob", {}).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(manager_->fork({"work", "d", 0, "half"}, "bob", {}).status().code(),
            StatusCode::kNotFound);
}

TEST_F(SessionPeopleTest, EditsThatCannotBeWrittenAreForgotten) {
  ASSERT_TRUE(apply("ann", SetGradientScale{0.25}).is_ok());
  const std::string id = manager_->list()[0].id;
  // Another's edit takes the next number: the journal must refuse the session's own edit.
  ASSERT_TRUE(journal_->append(id, 2, {{"eve", 0, {"x", SetGradientScale{2}}}}).is_on_disk());
  EXPECT_FALSE(apply("ann", SetGradientScale{0.5}).is_ok());
  EXPECT_EQ(beta(), 2);
  EXPECT_TRUE(apply("ann", SetGradientScale{0.5}).is_ok());
  EXPECT_EQ(beta(), 0.5);
}

}  // namespace
}  // namespace burnish
