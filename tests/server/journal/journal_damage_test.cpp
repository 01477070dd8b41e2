// A read finds damage to the journal's rows, and nothing else is lost with them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/journal.h"
#include "tests/server/journal/journal_place.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A journal with the session "a" of five edits.
class JournalDamageTest : public testing::TestWithParam<JournalKind> {
 protected:
  JournalDamageTest() {
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

  void start() {
    journal_ = place_.open();
    EXPECT_TRUE(journal_->hold("id-a").is_ok() || journal_->sessions().value().empty());
  }

  /// Changes the tables while the journal is closed.
  void damage(const char* sql) {
    journal_.reset();
    const Status status = place_.change(sql);
    ASSERT_TRUE(status.is_ok()) << status.message();
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

  JournalPlace place_{GetParam()};
  std::unique_ptr<Journal> journal_;
};

INSTANTIATE_TEST_SUITE_P(Kinds, JournalDamageTest, testing::ValuesIn(kJournalKinds), name_of_kind);

TEST_P(JournalDamageTest, AChangedValueOfAnEditIsFound) {
  EXPECT_THAT(damaged(), ElementsAre());
  damage("UPDATE edits SET bytes = (SELECT bytes FROM edits WHERE number = 1) WHERE number = 3");
  EXPECT_THAT(damaged(), ElementsAre(3));
  damage("UPDATE edits SET author = CAST('eve' AS BLOB) WHERE number = 4");
  EXPECT_THAT(damaged(), ElementsAre(3, 4));
  damage("UPDATE edits SET unix_ms = 77 WHERE number = 1");
  EXPECT_THAT(damaged(), ElementsAre(1, 3, 4));
  EXPECT_EQ(journal_->edit_count("id-a").value(), 5u);
}

TEST_P(JournalDamageTest, RowsThatWereSwappedAreFound) {
  damage(
      "UPDATE edits SET number = 100 - number WHERE number IN (2, 4);"
      "UPDATE edits SET number = number - 94 WHERE number IN (96, 98);");
  EXPECT_THAT(damaged(), ElementsAre(2, 4));
}

TEST_P(JournalDamageTest, ARowThatIsGoneLeavesItsNumber) {
  damage("DELETE FROM edits WHERE number = 2");
  EXPECT_THAT(damaged(), ElementsAre(2));
  EXPECT_THAT(summary(journal_->edits("id-a").value()[1].edit), HasSubstr("missing"));
}

TEST_P(JournalDamageTest, EditsThatAreGoneFromTheEndAreMissed) {
  damage("DELETE FROM edits WHERE number > 3");
  EXPECT_THAT(damaged(), ElementsAre(4, 5));
  EXPECT_TRUE(journal_->append("id-a", 6, {edit(6)}).is_on_disk());
  EXPECT_THAT(damaged(), ElementsAre(4, 5));
}

TEST_P(JournalDamageTest, EditsAreAppendedBehindADamagedOne) {
  damage("UPDATE edits SET bytes = x'' WHERE number = 5");
  ASSERT_TRUE(journal_->append("id-a", 6, {edit(6)}).is_on_disk());
  start();
  EXPECT_THAT(damaged(), ElementsAre(5));
  EXPECT_EQ(journal_->edits("id-a").value().size(), 6u);
}

TEST_P(JournalDamageTest, AForkOfADamagedSessionHasTheSameNumbers) {
  damage(
      "UPDATE edits SET id = CAST('e7' AS BLOB) WHERE number = 3;"
      "DELETE FROM edits WHERE number = 4");
  ASSERT_TRUE(journal_->fork_session(record("a"), 5, record("f"), {}).is_ok());
  EXPECT_THAT(damaged("id-f"), ElementsAre(3, 4));
  EXPECT_EQ(journal_->edits("id-f").value()[2].author, "ann");
  EXPECT_EQ(journal_->edit_count("id-f").value(), 5u);
}

TEST_P(JournalDamageTest, ASessionWhoseRecordIsDamagedIsMarkedAndKeptShut) {
  damage("UPDATE sessions SET depth = 8");
  const auto sessions = journal_->sessions().value();
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_TRUE(sessions[0].is_damaged);
  EXPECT_EQ(journal_->edits("id-a").status().code(), StatusCode::kDataLoss);
  EXPECT_TRUE(journal_->remove_session("id-a").is_ok());
}

TEST_P(JournalDamageTest, AMakerThatIsDamagedIsNobodyAndTheSessionGoesOn) {
  SessionRecord made = record("m");
  made.maker = "ann";
  ASSERT_TRUE(journal_->create_session(made, {}).is_ok());
  damage("UPDATE sessions SET maker = CAST('eve' AS BLOB) WHERE id = CAST('id-m' AS BLOB)");
  const auto sessions = journal_->sessions().value();
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[1].maker, std::nullopt);
  EXPECT_FALSE(sessions[1].is_damaged);
  EXPECT_TRUE(journal_->edits("id-m").is_ok());
}

TEST_P(JournalDamageTest, ARoleThatIsDamagedOrGoneIsTheLeast) {
  damage("UPDATE roles SET \"user\" = CAST('eve' AS BLOB) WHERE \"user\" = CAST('ann' AS BLOB)");
  EXPECT_EQ(journal_->roles("id-a").value().of("eve"), SessionRole::kViewer);
  damage("UPDATE roles SET role = 3 WHERE \"user\" = x''");
  EXPECT_EQ(journal_->roles("id-a").value().of("anybody"), SessionRole::kViewer);
  damage("DELETE FROM roles");
  EXPECT_EQ(journal_->roles("id-a").value().of("ann"), SessionRole::kViewer);
}

TEST_P(JournalDamageTest, NamesThatAreNotUtf8ComeBackAsText) {
  ASSERT_TRUE(
      journal_->append("id-a", 6, {{"M\xfcller", 0, {"x", SetGradientScale{1}}}}).is_on_disk());
  ASSERT_TRUE(journal_->set_role("id-a", "M\xfcller", SessionRole::kViewer).is_ok());
  EXPECT_EQ(journal_->edits("id-a").value()[5].author, "M\\xfcller");
  EXPECT_EQ(journal_->roles("id-a").value().of("M\\xfcller"), SessionRole::kViewer);
  ASSERT_TRUE(journal_->set_role("id-a", "M\\xfcller", SessionRole::kOwner).is_ok());
  EXPECT_EQ(journal_->roles("id-a").value().of("M\\xfcller"), SessionRole::kOwner);
}

TEST_P(JournalDamageTest, ACheckpointIsFoundWithoutOpeningTheSession) {
  ASSERT_TRUE(journal_->append("id-a", 6, {{"ann", 0, {"c", SetCheckpoint{"now"}}}}).is_on_disk());
  EXPECT_EQ(journal_->checkpoint("id-a", "now").value(), 6u);
  EXPECT_EQ(journal_->checkpoint("id-a", "then").status().code(), StatusCode::kNotFound);
}

}  // namespace
}  // namespace burnish
