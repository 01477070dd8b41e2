// A session with a damaged edit works; only that edit is lost.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "server/manager/session_manager.h"
#include "tests/server/manager/test_library.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// The session "one" with three edits on "ball", and a manager that can be restarted.
class SessionDamageTest : public testing::Test {
 protected:
  SessionDamageTest() {
    scan_id_ = library_.import(sphere_file(), "ball").value().scan.id;
    start();
    EXPECT_TRUE(manager_->open({"ball", "one", {5, 0}}, "ann", {}).is_ok());
    EXPECT_TRUE(apply("a", SetGradientScale{0.25}).is_ok());
    EXPECT_TRUE(apply("b", SetGradientScale{4}).is_ok());
    EXPECT_TRUE(apply("c", SetCheckpoint{"named"}).is_ok());
  }

  void stop() {
    manager_.reset();
    journal_.reset();
  }

  void start() {
    stop();
    library_.restart();
    journal_ = std::move(SqliteJournal::open(library_.folder->journal())).value();
    SessionManagerOptions options;
    options.solver.threads = 1;
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
            .value();
  }

  /// Changes the journal's file while it is closed.
  void damage(const char* sql) {
    stop();
    {
      Database database = std::move(Database::open(library_.folder->journal())).value();
      ASSERT_TRUE(database.execute(sql).is_ok());
    }
    start();
  }

  Result<ApplyOutcome> apply(const std::string& id, decltype(Edit::change) change) {
    const Edit edit{id, std::move(change)};
    return manager_->apply("one", "ann", {&edit, 1}, {});
  }

  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  std::string scan_id_;
};

TEST_F(SessionDamageTest, ASessionWithADamagedEditOpensTakesEditsAndIsExported) {
  damage("UPDATE edits SET bytes = x'0102' WHERE number = 2");
  EXPECT_EQ(manager_->state("one", {}).value().settings.beta, 0.25);
  const HistoryPage page = manager_->history({"one", 0, 100}, {}).value();
  ASSERT_EQ(page.entries.size(), 3u);
  EXPECT_EQ(page.entries[1].kind, EditKind::kDamaged);
  EXPECT_EQ(page.entries[1].number, 2u);
  EXPECT_EQ(page.entries[1].author, "ann");
  EXPECT_FALSE(page.entries[1].enabled);
  EXPECT_THAT(page.entries[1].summary, HasSubstr("damaged"));
  EXPECT_EQ(page.entries[2].number, 3u);

  EXPECT_EQ(apply("d", SwitchEntry{2, true}).status().code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(apply("e", SetGradientScale{2}).value().entries[0], 4u);
  EXPECT_TRUE(manager_->export_mesh("one", {MeshFormat::kPly, false, 1}, {}).is_ok());
  start();
  EXPECT_EQ(manager_->state("one", {}).value().settings.beta, 2);
}

TEST_F(SessionDamageTest, AForkOfASessionWithADamagedEditOpens) {
  damage("DELETE FROM edits WHERE number = 2");
  const auto fork = manager_->fork({"one", "two", 0, "named"}, "ann", {});
  ASSERT_TRUE(fork.is_ok()) << fork.status().message();
  EXPECT_EQ(fork->session.edits, 3u);
  EXPECT_EQ(manager_->state("two", {}).value().settings.beta, 0.25);
}

TEST_F(SessionDamageTest, AForkLeavesItsSourceOutOfMemory) {
  start();
  EXPECT_TRUE(manager_->fork({"one", "two", 1, ""}, "ann", {}).is_ok());
  EXPECT_EQ(manager_->fork({"one", "three", 9, ""}, "ann", {}).status().code(),
            StatusCode::kNotFound);
  EXPECT_EQ(manager_->usage().in_memory, 0u);
}

TEST_F(SessionDamageTest, ASessionWhoseRecordIsDamagedSaysSo) {
  damage("UPDATE sessions SET curvature_radius = 0.25");
  const Status status = manager_->state("one", {}).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(),
              HasSubstr("row in the journal (its name, scan and depth) is damaged"));
}

TEST_F(SessionDamageTest, ADamagedScanIsDeletedByItsFullId) {
  std::filesystem::resize_file(library_.folder->scans() / scan_id_ / "info.json", 20);
  start();
  EXPECT_EQ(manager_->delete_scan(scan_id_).status().code(), StatusCode::kFailedPrecondition);
  ASSERT_TRUE(manager_->remove("one", "ann", {}).is_ok());
  EXPECT_EQ(manager_->delete_scan(scan_id_.substr(0, 20)).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(manager_->delete_scan(std::string(64, 'a')).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(manager_->delete_scan("../" + scan_id_).status().code(), StatusCode::kNotFound);
  EXPECT_EQ(manager_->delete_scan(scan_id_).value(), scan_id_);
  EXPECT_FALSE(std::filesystem::exists(library_.folder->scans() / scan_id_));
}

}  // namespace
}  // namespace burnish
