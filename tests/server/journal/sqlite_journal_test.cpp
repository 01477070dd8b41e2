#include "server/journal/sqlite_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/wire/edit_bytes.h"
#include "server/journal/sqlite_schema.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::HasSubstr;

TEST(SqliteJournal, RemovingASessionGivesItsDiskBack) {
  const TemporaryFolder folder;
  auto journal = std::move(SqliteJournal::open(folder / "j.sqlite")).value();
  const SessionRecord record{"id-b", "b", std::string(64, 'a'), {7, 0.5}, 1234};
  ASSERT_TRUE(journal->create_session(record, {}).is_ok());
  SetCellFields large;
  large.cells.assign(100'000, {Vec3i(1, 2, 3), 1, 1, 1});
  ASSERT_TRUE(journal->append("id-b", 1, {{"ann", 0, {"x", large}}}).is_on_disk());
  ASSERT_TRUE(journal->remove_session("id-b").is_ok());
  // Each call waits for one of the few steps of giving space back.
  for (int step = 0; step < 50; ++step) ASSERT_TRUE(journal->edit_count("id-b").is_ok());
  journal.reset();
  EXPECT_LT(std::filesystem::file_size(folder / "j.sqlite"), 300'000u);
}

TEST(SqliteJournal, AFileThatIsNoJournalIsDataLoss) {
  const TemporaryFolder folder;
  folder.write("j.sqlite", std::string(5000, 'x'));
  const auto journal = SqliteJournal::open(folder / "j.sqlite");
  EXPECT_EQ(journal.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(journal.status().message(), HasSubstr("j.sqlite"));
  EXPECT_THAT(journal.status().message(), HasSubstr("backup")) << "the way out";
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

TEST(SqliteJournal, OfTheFirstVersionOpensWithAllItsEdits) {
  const TemporaryFolder folder;
  {
    Database database = std::move(Database::open(folder / "j.sqlite")).value();
    ASSERT_TRUE(database.execute(kVersion1).is_ok());
    insert_old_edit(database, "id-a", {"x", SetGradientScale{0.25}});
    insert_old_edit(database, "id-b", {"x", SetGradientScale{4}});
    insert_old_edit(database, "id-a", {"y", SetGradientScale{0.5}});
  }
  for (int time = 0; time < 2; ++time) {  // first to migrate, then to read the result
    const auto journal = std::move(SqliteJournal::open(folder / "j.sqlite")).value();
    const auto sessions = journal->sessions().value();
    ASSERT_EQ(sessions.size(), 2u);
    for (const SessionRecord& session : sessions) {
      EXPECT_FALSE(session.is_damaged);
      EXPECT_EQ(session.controls, Controls{}) << "its exports may not change";
      EXPECT_EQ(session.maker, std::nullopt);
    }
    const auto edits = journal->edits("id-a").value();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(edits[0].edit.id, "x");
    EXPECT_EQ(std::get<SetGradientScale>(edits[1].edit.change).beta, 0.5);
    EXPECT_EQ(edits[1].author, "");
    EXPECT_EQ(edits[1].unix_ms, 9000);
    EXPECT_EQ(journal->edit_count("id-b").value(), 1u);
    EXPECT_EQ(journal->roles("id-a").value().of("anybody"), SessionRole::kOwner);
    EXPECT_TRUE(journal->append("id-a", 3, {}).is_on_disk());
  }
}

// Takes a journal back to what the program before the makers wrote.
constexpr char kBackToVersion6[] = R"sql(
  ALTER TABLE sessions DROP COLUMN maker;
  ALTER TABLE sessions DROP COLUMN maker_checksum;
  PRAGMA user_version = 6;
)sql";

TEST(SqliteJournal, OfAProgramBeforeTheMakersTakesMakersFromThenOn) {
  const TemporaryFolder folder;
  const auto open = [&] { return std::move(SqliteJournal::open(folder / "j.sqlite")).value(); };
  SessionRecord record{"id-a", "a", std::string(64, 'a'), {7, 0.5}, 1234};
  ASSERT_TRUE(open()->create_session(record, SessionRoles::of_new_session("ann")).is_ok());
  {
    Database database = std::move(Database::open(folder / "j.sqlite")).value();
    ASSERT_TRUE(database.execute(kBackToVersion6).is_ok());
  }
  record.id = "id-b";
  record.name = "b";
  record.maker = "bob";
  ASSERT_TRUE(open()->create_session(record, SessionRoles::of_new_session("bob")).is_ok());
  const auto sessions = open()->sessions().value();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_FALSE(sessions[0].is_damaged);
  EXPECT_EQ(sessions[0].maker, std::nullopt);
  EXPECT_EQ(open()->roles("id-a").value().of("ann"), SessionRole::kOwner);
  EXPECT_EQ(sessions[1].maker, "bob");
}

TEST(SqliteJournal, OfANewerProgramIsRefused) {
  const TemporaryFolder folder;
  {
    Database database = std::move(Database::open(folder / "j.sqlite")).value();
    ASSERT_TRUE(database.execute("PRAGMA user_version = 99").is_ok());
  }
  const auto journal = SqliteJournal::open(folder / "j.sqlite");
  EXPECT_EQ(journal.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(journal.status().message(), HasSubstr("version is 99"));
  EXPECT_THAT(journal.status().message(), HasSubstr("backup"));
}

TEST(SqliteJournal, ADatabaseOfAnotherProgramIsNone) {
  const TemporaryFolder folder;
  const auto path = folder / "j.sqlite";
  ASSERT_TRUE(Database::open(path)->execute("CREATE TABLE birds (name TEXT)").is_ok());
  EXPECT_FALSE(has_journal_schema(path).value());
  const Status refused = SqliteJournal::open(path).status();
  EXPECT_EQ(refused.code(), StatusCode::kDataLoss);
  EXPECT_THAT(refused.message(), HasSubstr("another program"));
}

TEST(SqliteJournal, AnEmptyFileIsNoneUntilItIsOpened) {
  const TemporaryFolder folder;
  const auto path = folder / "j.sqlite";
  folder.write("j.sqlite", "");
  EXPECT_FALSE(has_journal_schema(path).value());
  EXPECT_EQ(std::filesystem::file_size(path), 0u);
  ASSERT_TRUE(SqliteJournal::open(path).is_ok());
  EXPECT_TRUE(has_journal_schema(path).value());
}

}  // namespace
}  // namespace burnish
