// Facts of a journal in PostgreSQL alone: servers that share it, lost connections, other versions.

#include "server/journal/postgres_journal.h"

#include <csignal>
#include <future>
#include <latch>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/postgres_rows.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/postgres/postgres_cluster.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using End = WriteOutcome::End;

AuthoredEdit slide(const std::string& id) {
  return {"ann", 0, {id, SetGradientScale{0.5}}};
}

/// A database with the session "a", and journals of several servers.
class PostgresJournalTest : public testing::Test {
 protected:
  PostgresJournalTest() {
    EXPECT_TRUE(
        first_->create_session({"id-a", "a", std::string(64, 'a'), {7, 0.5}, 1234}, {}).is_ok());
  }

  std::unique_ptr<PostgresJournal> open(const PostgresPatience& patience = {}) const {
    return std::move(PostgresJournal::open(PgAddress::parse(uri_).value(), folder_ / "p.sqlite",
                                           patience))
        .value();
  }

  PgConnection connection() const {
    return PgConnection::open(PgAddress::parse(uri_).value(), {}, "test").value();
  }

  void sql(const std::string& script) const {
    const Status status = connection().script(script.c_str());
    EXPECT_TRUE(status.is_ok()) << status.message();
  }

  /// Ends the connections of all journals, like a failover.
  void cut() const {
    sql("SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name = 'burnish'"
        " AND datname = current_database()");
  }

  PostgresCluster& cluster_ = PostgresCluster::shared();
  const TemporaryFolder folder_;
  const std::string uri_ = cluster_.make_database();
  std::unique_ptr<PostgresJournal> first_ = open();
};

TEST_F(PostgresJournalTest, TheServerThatHeldASessionBeforeIsFenced) {
  ASSERT_TRUE(first_->append("id-a", 1, {slide("1")}).is_on_disk());
  const auto second = open();
  ASSERT_TRUE(second->hold("id-a").is_ok());
  EXPECT_EQ(first_->append("id-a", 2, {slide("2")}).end(), End::kUnknown);
  EXPECT_EQ(first_->append("id-a", 2, {}).end(), End::kUnknown);
  EXPECT_TRUE(second->append("id-a", 2, {slide("2")}).is_on_disk());
  ASSERT_TRUE(first_->hold("id-a").is_ok());
  EXPECT_EQ(second->append("id-a", 3, {slide("3")}).end(), End::kUnknown);
  EXPECT_EQ(first_->edit_count("id-a").value(), 2u);
}

TEST_F(PostgresJournalTest, AFencedAppendDoesNotTouchTheOthersOfItsCommit) {
  ASSERT_TRUE(first_->create_session({"id-b", "b", "s", {7, 0}, 1}, {}).is_ok());
  const auto second = open();
  ASSERT_TRUE(second->hold("id-a").is_ok());
  std::latch is_held_up(1), go_on(1);
  first_->append("id-b", 1, {slide("1")}, [&](const WriteOutcome&) {
    is_held_up.count_down();
    go_on.wait();
  });
  is_held_up.wait();
  std::promise<End> fenced, good;
  first_->append("id-a", 1, {slide("1")},
                 [&](const WriteOutcome& o) { fenced.set_value(o.end()); });
  first_->append("id-b", 2, {slide("2")}, [&](const WriteOutcome& o) { good.set_value(o.end()); });
  go_on.count_down();
  EXPECT_EQ(fenced.get_future().get(), End::kUnknown);
  EXPECT_EQ(good.get_future().get(), End::kOnDisk);
}

TEST_F(PostgresJournalTest, AppendsGoOnOverABrokenConnection) {
  for (int i = 1; i <= 3; ++i) {
    cut();
    EXPECT_TRUE(
        first_->append("id-a", static_cast<uint64_t>(i), {slide(std::to_string(i))}).is_on_disk());
  }
  cut();
  EXPECT_EQ(first_->edits("id-a").value().size(), 3u);
}

TEST_F(PostgresJournalTest, AnAppendThatWasWrittenUnheardIsFoundWhenItComesAgain) {
  ASSERT_TRUE(first_->append("id-a", 1, {slide("1"), slide("2")}).is_on_disk());
  EXPECT_TRUE(first_->append("id-a", 1, {slide("1"), slide("2")}).is_on_disk());
  EXPECT_EQ(first_->append("id-a", 1, {slide("1"), slide("3")}).end(), End::kRefused);
  EXPECT_EQ(first_->edit_count("id-a").value(), 2u);
}

TEST_F(PostgresJournalTest, AnAppendWaitsForARowOfAStatementThatWasGivenUp) {
  PostgresPatience patience;
  patience.connection.reply = milliseconds(300);
  first_ = open(patience);
  ASSERT_TRUE(first_->hold("id-a").is_ok());
  PgConnection other = connection();
  ASSERT_TRUE(other.script("BEGIN; SELECT 1 FROM sessions FOR UPDATE").is_ok());
  std::promise<WriteOutcome> written;
  first_->append("id-a", 1, {slide("1")}, [&](const WriteOutcome& o) { written.set_value(o); });
  auto outcome = written.get_future();
  EXPECT_EQ(outcome.wait_for(milliseconds(1000)), std::future_status::timeout);
  ASSERT_TRUE(other.script("COMMIT").is_ok());
  EXPECT_TRUE(outcome.get().is_on_disk());
  EXPECT_EQ(first_->edits("id-a").value().size(), 1u);
}

TEST_F(PostgresJournalTest, ADatabaseThatStaysAwayLeavesTheOutcomeUnknown) {
  PostgresCluster cluster("fsync=off");
  PostgresPatience patience;
  patience.away = milliseconds(500);
  auto journal = std::move(PostgresJournal::open(PgAddress::parse(cluster.make_database()).value(),
                                                 folder_ / "q.sqlite", patience))
                     .value();
  ASSERT_TRUE(journal->create_session({"id-a", "a", "s", {7, 0}, 1}, {}).is_ok());
  ASSERT_TRUE(journal->append("id-a", 1, {slide("1")}).is_on_disk());
  cluster.kill();
  EXPECT_EQ(journal->append("id-a", 2, {slide("2")}).end(), End::kUnknown);
  EXPECT_EQ(journal->edits("id-a").status().code(), StatusCode::kUnavailable);
  cluster.start();
  EXPECT_EQ(journal->edits("id-a").value().size(), 1u);
  EXPECT_TRUE(journal->append("id-a", 2, {slide("2")}).is_on_disk());
}

TEST_F(PostgresJournalTest, AnAppendIsOnDiskThoughTheDatabaseWasKilledMeanwhile) {
  PostgresCluster cluster("fsync=off");
  auto journal = std::move(PostgresJournal::open(PgAddress::parse(cluster.make_database()).value(),
                                                 folder_ / "q.sqlite"))
                     .value();
  ASSERT_TRUE(journal->create_session({"id-a", "a", "s", {7, 0}, 1}, {}).is_ok());
  cluster.kill();
  std::promise<WriteOutcome> written;
  journal->append("id-a", 1, {slide("1")}, [&](const WriteOutcome& o) { written.set_value(o); });
  cluster.start();
  EXPECT_TRUE(written.get_future().get().is_on_disk());
  EXPECT_EQ(journal->edit_count("id-a").value(), 1u);
}

TEST_F(PostgresJournalTest, AFrozenDatabaseIsGivenUpInTime) {
  PostgresCluster cluster("fsync=off");
  PostgresPatience patience;
  patience.connection = {milliseconds(300), milliseconds(300)};
  patience.away = milliseconds(500);
  auto journal = std::move(PostgresJournal::open(PgAddress::parse(cluster.make_database()).value(),
                                                 folder_ / "q.sqlite", patience))
                     .value();
  ASSERT_TRUE(journal->create_session({"id-a", "a", "s", {7, 0}, 1}, {}).is_ok());
  cluster.signal_all(SIGSTOP);
  const WriteOutcome outcome = journal->append("id-a", 1, {slide("1")});
  cluster.signal_all(SIGCONT);
  EXPECT_EQ(outcome.end(), End::kUnknown);
  EXPECT_THAT(outcome.status().message(), HasSubstr("300 ms"));
}

TEST_F(PostgresJournalTest, ACommitThatDidNotWaitForItsStandbyIsUnknown) {
  PostgresCluster cluster("fsync=off");
  const std::string uri = cluster.make_database();
  PostgresPatience patience;
  patience.away = milliseconds(0);
  auto journal = std::move(PostgresJournal::open(PgAddress::parse(uri).value(),
                                                 folder_ / "q.sqlite", patience))
                     .value();
  ASSERT_TRUE(journal->create_session({"id-a", "a", "s", {7, 0}, 1}, {}).is_ok());
  PgConnection admin = PgConnection::open(PgAddress::parse(uri).value(), {}, "admin").value();
  ASSERT_TRUE(admin.script("ALTER SYSTEM SET synchronous_standby_names = 'nobody'").is_ok());
  ASSERT_TRUE(admin.script("SELECT pg_reload_conf()").is_ok());
  // Until the server has read its settings, commits do not wait.
  std::promise<WriteOutcome> written;
  std::jthread canceller([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      (void)admin.run(
          {"SELECT pg_cancel_backend(pid) FROM pg_stat_activity"
           " WHERE wait_event = 'SyncRep'",
           {}});
      std::this_thread::sleep_for(milliseconds(10));
    }
  });
  End end = End::kOnDisk;
  uint64_t number = 0;
  while (end == End::kOnDisk) {
    ++number;
    end = journal->append("id-a", number, {slide(std::to_string(number))}).end();
  }
  EXPECT_EQ(end, End::kUnknown);
}

TEST_F(PostgresJournalTest, AJournalOfTheNextProgramIsTakenAndALaterOneRefused) {
  first_.reset();
  sql("UPDATE burnish.version SET number = 5");
  EXPECT_EQ(open()->sessions().value().size(), 1u);
  sql("UPDATE burnish.version SET number = 6");
  const auto refused = PostgresJournal::open(PgAddress::parse(uri_).value(), folder_ / "p.sqlite");
  EXPECT_EQ(refused.status().code(), StatusCode::kDataLoss);
  EXPECT_THAT(refused.status().message(), HasSubstr("version is 6"));
}

// While a fleet is upgraded, the program before the makers writes rows without them. It reads the
// row's checksum over the values that it knows.
TEST_F(PostgresJournalTest, AServerBeforeTheMakersSharesTheTables) {
  SessionRecord made{"id-b", "b", std::string(64, 'a'), {7, 0.5}, 1234};
  const std::string sum_without_maker = checksum_of(made);
  made.maker = "ann";
  ASSERT_TRUE(first_->create_session(made, {}).is_ok());
  const PgReply sum =
      connection().run({"SELECT checksum FROM burnish.sessions WHERE id = $1", {made.id}}).value();
  EXPECT_EQ(sum.bytes(0, 0), sum_without_maker);
  sql("INSERT INTO burnish.sessions (id, name, scan_id, depth, curvature_radius,"
      " created_unix_seconds, pins_rims, checksum) SELECT id || 'x', name || 'x', scan_id, depth,"
      " curvature_radius, created_unix_seconds, pins_rims, checksum FROM burnish.sessions"
      " WHERE maker = 'ann'");
  const auto sessions = open()->sessions().value();
  ASSERT_EQ(sessions.size(), 3u);
  EXPECT_EQ(sessions[1].maker, "ann");
  EXPECT_EQ(sessions[2].maker, std::nullopt);
}

TEST_F(PostgresJournalTest, OfTheProgramBeforeTheMakersKeepsItsSessions) {
  first_.reset();
  sql("ALTER TABLE burnish.sessions DROP COLUMN maker, DROP COLUMN maker_checksum;"
      " UPDATE burnish.version SET number = 3");
  const auto sessions = open()->sessions().value();
  ASSERT_EQ(sessions.size(), 1u);
  EXPECT_FALSE(sessions[0].is_damaged);
  EXPECT_EQ(sessions[0].maker, std::nullopt);
}

TEST_F(PostgresJournalTest, ServersThatStartAtOnceMakeTheTablesOnce) {
  const PgAddress address = PgAddress::parse(cluster_.make_database()).value();
  std::vector<std::jthread> servers;
  std::atomic<int> opened{0};
  for (int i = 0; i < 4; ++i)
    servers.emplace_back([&, i] {
      const auto journal =
          PostgresJournal::open(address, folder_ / (std::to_string(i) + ".sqlite"));
      EXPECT_TRUE(journal.is_ok()) << journal.status().message();
      opened += journal.is_ok();
    });
  servers.clear();
  EXPECT_EQ(opened, 4);
}

TEST_F(PostgresJournalTest, CommitsWaitForTheDiskWhateverTheDatabasesSettingsSay) {
  sql("DO $$ BEGIN EXECUTE 'ALTER DATABASE ' || current_database() ||"
      " ' SET synchronous_commit = off'; END $$");
  PgConnection fresh = connection();
  EXPECT_EQ(fresh.run({"SHOW synchronous_commit", {}})->bytes(0, 0), "on");
}

TEST(PgAddress, APasswordInItIsRefusedAndNotRepeated) {
  for (const char* uri :
       {"postgresql://ann:secret@db/burnish", "postgresql://db/burnish?password=secret",
        "postgresql://ann:secret@d b", "mysql://secret"}) {
    const Status status = PgAddress::parse(uri).status();
    EXPECT_EQ(status.code(), StatusCode::kInvalidArgument) << uri;
    EXPECT_THAT(status.message(), testing::Not(HasSubstr("secret")));
  }
}

TEST(PgAddress, HostsAreTriedInTheirOrder) {
  const PgAddress address = PgAddress::parse("postgresql://a:1,b:2/burnish").value();
  ASSERT_EQ(address.hosts().size(), 2u);
  EXPECT_EQ(address.hosts()[1].name, "b");
  EXPECT_EQ(address.hosts()[1].port, "2");
  const std::string here = PostgresCluster::shared().folder().string();
  const auto reached = PgConnection::open(
      PgAddress::parse("postgresql://burnish@/postgres?host=/nowhere," + here).value(), {}, "test");
  EXPECT_TRUE(reached.is_ok()) << reached.status().message();
}

}  // namespace
}  // namespace burnish
