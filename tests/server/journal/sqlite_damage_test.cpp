// Damage to a journal's own file, and to the file of its ends.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/sqlite_journal.h"
#include "tests/common/temporary_folder.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// A journal with the session "a" of five edits.
class SqliteDamageTest : public testing::Test {
 protected:
  SqliteDamageTest() {
    start();
    EXPECT_TRUE(journal_->create_session(record("a"), SessionRoles::of_new_session("ann")).is_ok());
    for (uint64_t number = 1; number <= 5; ++number)
      EXPECT_TRUE(journal_->append("id-a", number, {edit(number)}).is_on_disk());
  }

  static SessionRecord record(const std::string& name) {
    return {"id-" + name, name, std::string(64, 'a'), {7, 0.5}, 1234};
  }

  static AuthoredEdit edit(uint64_t number) {
    return {number % 2 ? "ann" : "bob",
            static_cast<int64_t>(number),
            {"e" + std::to_string(number), SetGradientScale{0.1 * static_cast<double>(number)}}};
  }

  void start() { journal_ = std::move(SqliteJournal::open(folder_ / "j.sqlite")).value(); }

  /// Changes the file while the journal is closed.
  void damage(const char* sql) {
    journal_.reset();
    {
      Database database = std::move(Database::open(folder_ / "j.sqlite")).value();
      ASSERT_TRUE(database.execute("PRAGMA foreign_keys=OFF").is_ok());
      const Status status = database.execute(sql);
      ASSERT_TRUE(status.is_ok()) << status.message();
    }
    start();
  }

  /// Returns the numbers of the damaged edits; the others must be as they were written.
  std::vector<uint64_t> damaged(const std::string& id = "id-a") {
    std::vector<uint64_t> numbers;
    const auto edits = journal_->edits(id).value();
    for (uint64_t number = 1; number <= edits.size(); ++number) {
      const AuthoredEdit& read = edits[number - 1];
      if (kind_of(read.edit) == EditKind::kDamaged) {
        numbers.push_back(number);
      } else {
        EXPECT_EQ(read.author, edit(number).author);
        EXPECT_EQ(read.unix_ms, edit(number).unix_ms);
        EXPECT_EQ(read.edit.id, edit(number).edit.id);
        EXPECT_EQ(summary(read.edit), summary(edit(number).edit));
      }
    }
    return numbers;
  }

  const TemporaryFolder folder_;
  std::unique_ptr<Journal> journal_;
};

TEST_F(SqliteDamageTest, ADamagedEndIsCountedAnew) {
  damage("UPDATE ends SET number = 3");
  EXPECT_EQ(journal_->edit_count("id-a").value(), 5u);
  EXPECT_THAT(damaged(), ElementsAre());
  EXPECT_TRUE(journal_->append("id-a", 6, {edit(6)}).is_on_disk());
}

TEST_F(SqliteDamageTest, ANameThatDamageMadeAnothersOneIsToldApart) {
  ASSERT_TRUE(journal_->create_session(record("b"), {}).is_ok());
  ASSERT_TRUE(journal_->create_session(record("c"), {}).is_ok());
  journal_.reset();
  std::string bytes = content_of(folder_ / "j.sqlite");
  const size_t name = bytes.find("id-bb") + 4;
  ASSERT_LT(name, bytes.size());
  bytes[name] ^= 1;
  folder_.write("j.sqlite", bytes);
  start();
  const auto sessions = journal_->sessions().value();
  ASSERT_EQ(sessions.size(), 3u);
  EXPECT_EQ(sessions[1].is_damaged ? sessions[1].name : sessions[2].name, "c-id-b");
  EXPECT_EQ(sessions[1].is_damaged ? sessions[2].name : sessions[1].name, "c");
}

TEST_F(SqliteDamageTest, WhatTheEndOfTheWriteAheadLogHasLostIsMissed) {
  // Leaves the files like a power cut and a bad block: the end of the log is lost.
  const fs::path copy = folder_ / "copy.sqlite";
  fs::copy(folder_ / "j.sqlite", copy);
  fs::copy(folder_ / "j.sqlite-wal", folder_ / "copy.sqlite-wal");
  fs::copy(folder_ / "j.ends", folder_ / "copy.ends");
  fs::resize_file(folder_ / "copy.sqlite-wal", fs::file_size(folder_ / "copy.sqlite-wal") - 1);
  journal_ = std::move(SqliteJournal::open(copy)).value();
  EXPECT_EQ(journal_->edit_count("id-a").value(), 5u);
  EXPECT_THAT(damaged(), ElementsAre(5));
  EXPECT_TRUE(journal_->append("id-a", 6, {edit(6)}).is_on_disk());
}

TEST_F(SqliteDamageTest, WithoutItsHintOfTheEndsAJournalIsWhatItSays) {
  journal_.reset();
  for (const char* content : {"", "id-a 9 0123456789abcdef", "\xff\xfe nonsense"}) {
    folder_.write("j.ends", content);
    start();
    EXPECT_EQ(journal_->edit_count("id-a").value(), 5u);
    journal_.reset();
  }
  fs::remove(folder_ / "j.ends");
  start();
  EXPECT_THAT(damaged(), ElementsAre());
}

TEST_F(SqliteDamageTest, ARemovedSessionIsNotMissed) {
  ASSERT_TRUE(journal_->create_session(record("b"), {}).is_ok());
  ASSERT_TRUE(journal_->append("id-b", 1, {edit(1)}).is_on_disk());
  ASSERT_TRUE(journal_->remove_session("id-a").is_ok());
  const std::string ends = content_of(folder_ / "j.ends");
  EXPECT_THAT(ends, testing::Not(HasSubstr("id-a")));
  EXPECT_THAT(ends, HasSubstr("id-b 1 "));
}

}  // namespace
}  // namespace burnish
