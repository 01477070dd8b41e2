#include "server/journal/journal.h"

#include <future>
#include <latch>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/wire/edit_bytes.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

SessionRecord record(const std::string& name) {
  return {"id-" + name, name, std::string(64, 'a'), {7, 0.5}, 1234};
}

std::vector<AuthoredEdit> some_edits() {
  return {{"ann", 1, {"1", SetGradientScale{0.5}}},
          {"bob", 2, {"1", SetTransferCurve{TransferCurve(20)}}},
          {"", 3, {"3", Stroke{{1, 1, 2, FallOff::kSmooth}, {Vec3d(1, 2, 3)}}}},
          {"ann", 4, {"4", Undo{}}}};
}

AuthoredEdit slider(const std::string& id) {
  return {"ann", 0, {id, SetGradientScale{0.5}}};
}

/// A journal in its own folder, with the session "a".
class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    start();
    EXPECT_TRUE(journal_->create_session(record("a"), {}).is_ok());
  }

  void start() {
    journal_.reset();
    journal_ = std::move(Journal::open(folder_ / "j.sqlite")).value();
  }

  const TemporaryFolder folder_;
  std::unique_ptr<Journal> journal_;
};

TEST_F(JournalTest, SessionsAndEditsComeBackFromANewProgram) {
  ASSERT_TRUE(journal_->create_session(record("b"), {}).is_ok());
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_ok());
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

TEST_F(JournalTest, ASessionKeepsTheControlsThatItWasBornWith) {
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

TEST_F(JournalTest, ABatchWithAKnownIdIsKeptOutWhole) {
  ASSERT_TRUE(journal_->append("id-a", 1, {slider("x")}).is_ok());
  EXPECT_EQ(journal_->append("id-a", 2, {slider("y"), slider("x")}).code(),
            StatusCode::kAlreadyExists);
  EXPECT_EQ(journal_->edit_count("id-a").value(), 1u);
}

TEST_F(JournalTest, EditsBehindOneThatWasLostAreRefused) {
  ASSERT_TRUE(journal_->append("id-a", 1, {slider("x")}).is_ok());
  EXPECT_EQ(journal_->append("id-a", 3, {slider("z")}).code(), StatusCode::kDataLoss);
  EXPECT_EQ(journal_->append("id-a", 3, {}).code(), StatusCode::kDataLoss);
  EXPECT_TRUE(journal_->append("id-a", 2, {}).is_ok());
}

TEST_F(JournalTest, EditsThatComeWhileACommitIsUnderWayShareTheNextOne) {
  constexpr int kEdits = 20;
  std::latch first_is_written(1), go_on(1), all_are_written(kEdits);
  journal_->append("id-a", 1, {slider("0")}, [&](const Status&) {
    first_is_written.count_down();
    go_on.wait();
  });
  first_is_written.wait();
  const uint64_t commits = journal_->commits();
  for (int i = 1; i <= kEdits; ++i)
    journal_->append("id-a", static_cast<uint64_t>(i + 1), {slider(std::to_string(i))},
                     [&](const Status& status) {
                       EXPECT_TRUE(status.is_ok()) << status.message();
                       all_are_written.count_down();
                     });
  go_on.count_down();
  all_are_written.wait();
  EXPECT_EQ(journal_->commits(), commits + 1);
}

TEST_F(JournalTest, AFailureDoesNotTouchTheOthersOfItsCommit) {
  std::latch first_is_written(1), go_on(1);
  std::promise<Status> good, bad;
  journal_->append("id-a", 1, {slider("0")}, [&](const Status&) {
    first_is_written.count_down();
    go_on.wait();
  });
  first_is_written.wait();
  journal_->append("nobody", 1, {slider("1")}, [&](const Status& s) { bad.set_value(s); });
  journal_->append("id-a", 2, {slider("1")}, [&](const Status& s) { good.set_value(s); });
  go_on.count_down();
  EXPECT_FALSE(bad.get_future().get().is_ok());
  EXPECT_TRUE(good.get_future().get().is_ok());
  EXPECT_EQ(journal_->edit_count("id-a").value(), 2u);
}

TEST_F(JournalTest, RemovingASessionForgetsItsEdits) {
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_ok());
  ASSERT_TRUE(journal_->remove_session("id-a").is_ok());
  EXPECT_TRUE(journal_->sessions().value().empty());
  EXPECT_TRUE(journal_->edits("id-a").value().empty());
}

TEST_F(JournalTest, RemovingASessionGivesItsDiskBack) {
  ASSERT_TRUE(journal_->create_session(record("b"), {}).is_ok());
  SetCellFields large;
  large.cells.assign(100'000, {Vec3i(1, 2, 3), 1, 1, 1});
  ASSERT_TRUE(journal_->append("id-b", 1, {{"ann", 0, {"x", large}}}).is_ok());
  ASSERT_TRUE(journal_->remove_session("id-b").is_ok());
  // Each call waits for one of the few steps of giving space back.
  for (int step = 0; step < 50; ++step) ASSERT_TRUE(journal_->edit_count("id-a").is_ok());
  journal_.reset();
  EXPECT_LT(std::filesystem::file_size(folder_ / "j.sqlite"), 300'000u);
}

TEST_F(JournalTest, EditsOfNoSessionAreRefused) {
  EXPECT_FALSE(journal_->append("nobody", 1, some_edits()).is_ok());
}

TEST_F(JournalTest, AForkHasTheFirstEditsOfItsSource) {
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_ok());
  ASSERT_TRUE(journal_->fork_session(record("a"), 2, record("f"), {}).is_ok());
  EXPECT_EQ(journal_->edit_count("id-f").value(), 2u);
  EXPECT_EQ(journal_->edits("id-f").value()[1].author, "bob");
  EXPECT_EQ(journal_->fork_session(record("a"), 5, record("g"), {}).status().code(),
            StatusCode::kDataLoss);
  EXPECT_EQ(journal_->sessions().value().size(), 2u);
}

TEST_F(JournalTest, AForkAtAnotherDepthHasNoCellFieldsAndNoPaint) {
  const SetCellFields cells{{{Vec3i(1, 2, 3), 1, 1, 1}}};
  ASSERT_TRUE(journal_->append("id-a", 1, some_edits()).is_ok());
  const uint64_t count = journal_->edit_count("id-a").value();
  ASSERT_TRUE(journal_->append("id-a", count + 1, {{"ann", 0, {"cells", cells}}}).is_ok());
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

TEST_F(JournalTest, RolesComeBackFromANewProgram) {
  ASSERT_TRUE(journal_->create_session(record("b"), SessionRoles::of_new_session("ann")).is_ok());
  ASSERT_TRUE(journal_->set_role("id-b", "bob", SessionRole::kViewer).is_ok());
  start();
  EXPECT_EQ(journal_->roles("id-b").value().of("ann"), SessionRole::kOwner);
  EXPECT_EQ(journal_->roles("id-b").value().of("bob"), SessionRole::kViewer);
  EXPECT_EQ(journal_->roles("id-b").value().of("eve"), SessionRole::kEditor);
  EXPECT_EQ(journal_->roles("id-a").value().of("eve"), SessionRole::kOwner);
}

TEST_F(JournalTest, OfPaintTheNewestIsKept) {
  for (uint64_t strokes = 1; strokes <= 10; ++strokes)
    journal_->keep_paint("id-a", {100 + strokes, strokes, {{1, 3}, {0.5f, 2}, {1, 0.25f}}});
  const auto kept = journal_->paint("id-a", 4).value();
  ASSERT_EQ(kept.size(), 8u);
  EXPECT_EQ(kept.back().series, 110u);
  EXPECT_EQ(kept.back().strokes, 10u);
  EXPECT_EQ(kept.back().painted.value, (std::vector<float>{0.5f, 2}));
  EXPECT_TRUE(journal_->paint("id-a", 3).value().empty());  // for another mesh
}

TEST(Journal, AFileThatIsNoJournalIsDataLoss) {
  const TemporaryFolder folder;
  folder.write("j.sqlite", std::string(5000, 'x'));
  const auto journal = Journal::open(folder / "j.sqlite");
  EXPECT_EQ(journal.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(journal.status().message(), HasSubstr("j.sqlite"));
}

// The schema of the first released program.
constexpr char kVersion1[] = R"sql(
  CREATE TABLE sessions (
    id BLOB PRIMARY KEY, name BLOB NOT NULL UNIQUE, scan_id BLOB NOT NULL,
    depth INTEGER NOT NULL, curvature_radius REAL NOT NULL, created_unix_seconds INTEGER NOT NULL
  ) WITHOUT ROWID;
  CREATE TABLE edits (
    sequence INTEGER PRIMARY KEY AUTOINCREMENT,
    session_id BLOB NOT NULL REFERENCES sessions(id) ON DELETE CASCADE,
    id BLOB NOT NULL, bytes BLOB NOT NULL, UNIQUE (session_id, id)
  );
  PRAGMA user_version = 1;
  INSERT INTO sessions VALUES (CAST('id-a' AS BLOB), CAST('a' AS BLOB), CAST('s' AS BLOB), 7, 0, 9);
  INSERT INTO sessions VALUES (CAST('id-b' AS BLOB), CAST('b' AS BLOB), CAST('s' AS BLOB), 7, 0, 8);
)sql";

void insert_old_edit(Database& database, const std::string& session, const Edit& edit) {
  auto insert =
      database.prepare("INSERT INTO edits (session_id, id, bytes) VALUES (?, ?, ?)").value();
  ASSERT_TRUE(insert.bind(session, edit.id, edit_to_bytes(edit)).run().is_ok());
}

TEST(Journal, OfTheFirstVersionOpensWithAllItsEdits) {
  const TemporaryFolder folder;
  {
    Database database = std::move(Database::open(folder / "j.sqlite")).value();
    ASSERT_TRUE(database.execute(kVersion1).is_ok());
    insert_old_edit(database, "id-a", {"x", SetGradientScale{0.25}});
    insert_old_edit(database, "id-b", {"x", SetGradientScale{4}});
    insert_old_edit(database, "id-a", {"y", SetGradientScale{0.5}});
  }
  for (int time = 0; time < 2; ++time) {  // first to migrate, then to read the result
    const auto journal = std::move(Journal::open(folder / "j.sqlite")).value();
    const auto sessions = journal->sessions().value();
    ASSERT_EQ(sessions.size(), 2u);
    for (const SessionRecord& session : sessions) {
      EXPECT_FALSE(session.is_damaged);
      EXPECT_EQ(session.controls, Controls{}) << "its exports may not change";
    }
    const auto edits = journal->edits("id-a").value();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(edits[0].edit.id, "x");
    EXPECT_EQ(std::get<SetGradientScale>(edits[1].edit.change).beta, 0.5);
    EXPECT_EQ(edits[1].author, "");
    EXPECT_EQ(edits[1].unix_ms, 9000);
    EXPECT_EQ(journal->edit_count("id-b").value(), 1u);
    EXPECT_EQ(journal->roles("id-a").value().of("anybody"), SessionRole::kOwner);
    EXPECT_TRUE(journal->append("id-a", 3, {}).is_ok());
  }
}

TEST(Journal, OfANewerProgramIsRefused) {
  const TemporaryFolder folder;
  {
    Database database = std::move(Database::open(folder / "j.sqlite")).value();
    ASSERT_TRUE(database.execute("PRAGMA user_version = 99").is_ok());
  }
  const auto journal = Journal::open(folder / "j.sqlite");
  EXPECT_EQ(journal.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(journal.status().message(), HasSubstr("version is 99"));
}

}  // namespace
}  // namespace burnish
