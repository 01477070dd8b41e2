#include "server/fleet/membership.h"

#include <atomic>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/journal/postgres_journal.h"
#include "tests/common/temporary_folder.h"
#include "tests/server/postgres/postgres_cluster.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using End = WriteOutcome::End;

constexpr LeaseTimes kShortTimes{milliseconds(600), milliseconds(100)};

/// A server's journal and its place in the fleet.
struct Member {
  Member(const PgAddress& address, const std::filesystem::path& folder, const std::string& name)
      : journal(PostgresJournal::open(address, folder / (name + ".sqlite")).value()),
        membership(Membership::join(address, {name, name + ".lab:7411"}, kShortTimes).value()) {
    journal->begin_life(membership->first_life());
  }

  void start() {
    beating = membership->start({.on_new_life =
                                     [this](const std::string& life) {
                                       journal->begin_life(life);
                                       ++lives;
                                     },
                                 .load = [this] { return load; },
                                 .on_heartbeat =
                                     [this](const std::vector<std::string>& addresses) {
                                       ++beats;
                                       fleet_size = addresses.size();
                                     }});
  }

  /// The database has the clock of leases, so this waits.
  template <typename What>
  static bool until(What what) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!what()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(milliseconds(10));
    }
    return true;
  }

  WriteOutcome append(uint64_t number) const {
    const std::string id = std::to_string(number);
    return journal->append("id-a", number, {{"ann", 0, {id, SetGradientScale{0.5}}}});
  }

  NodeLoad load;
  std::atomic<int> lives{1}, beats{0};
  std::atomic<size_t> fleet_size{0};  // of the last heartbeat
  std::unique_ptr<PostgresJournal> journal;
  std::unique_ptr<Membership> membership;
  std::jthread beating;  // ends first
};

/// A fleet whose member "one" holds the session "a" with one edit.
class MembershipTest : public testing::Test {
 protected:
  MembershipTest() {
    one_ = std::make_unique<Member>(address_, folder_.path(), "one");
    EXPECT_TRUE(one_->journal->create_session({"id-a", "a", "s", {7, 0.5}, 1}, {}).is_ok());
    EXPECT_TRUE(one_->append(1).is_on_disk());
  }

  void sql(const char* script) const {
    EXPECT_TRUE(PgConnection::open(address_, {}, "test")->script(script).is_ok());
  }

  PostgresCluster cluster_{"fsync=off"};
  const TemporaryFolder folder_;
  const PgAddress address_ = PgAddress::parse(cluster_.make_database()).value();
  std::unique_ptr<Member> one_;
};

TEST_F(MembershipTest, AHeartbeatTellsTheAddressesOfAllServers) {
  one_->start();
  Member two(address_, folder_.path(), "two");
  EXPECT_TRUE(Member::until([this] { return one_->fleet_size == 2; }));
}

TEST_F(MembershipTest, ASessionOfALivingServerIsRefusedWithItsNameAndAddress) {
  one_->start();
  const Member two(address_, folder_.path(), "two");
  const Status refused = two.journal->hold("id-a");
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("one (one.lab:7411)"));
  EXPECT_EQ(ServerPlace::of(refused.moved_to()), (ServerPlace{"one.lab:7411", "one"}));
}

TEST_F(MembershipTest, WhoeverDoesNotHoldASessionChangesNothingOfIt) {
  Member two(address_, folder_.path(), "two");
  sql("UPDATE sessions SET owner = NULL");
  ASSERT_TRUE(two.journal->hold("id-a").is_ok());
  for (const Status& refused :
       {one_->journal->rename_session("id-a", "b"), one_->journal->remove_session("id-a"),
        one_->journal->set_role("id-a", "bert", SessionRole::kOwner),
        one_->journal->charge("id-a", "ann", 16)}) {
    EXPECT_EQ(ServerPlace::of(refused.moved_to()).node, "two") << refused.to_string();
  }
  EXPECT_EQ(two.journal->sessions().value()[0].name, "a");
  EXPECT_FALSE(two.journal->roles("id-a")->by_user().contains("bert"));
  EXPECT_TRUE(two.journal->set_role("id-a", "bert", SessionRole::kEditor).is_ok());
  EXPECT_TRUE(two.journal->rename_session("id-a", "b").is_ok());
  EXPECT_TRUE(two.journal->remove_session("id-a").is_ok());
}

TEST_F(MembershipTest, AFreedSessionIsToBeTakenAgainBeforeItsNextChange) {
  sql("UPDATE sessions SET owner = NULL");
  EXPECT_EQ(one_->journal->rename_session("id-a", "b").code(), StatusCode::kUnavailable);
  ASSERT_TRUE(one_->journal->hold("id-a").is_ok());
  EXPECT_TRUE(one_->journal->rename_session("id-a", "b").is_ok());
}

TEST_F(MembershipTest, SessionsOfAUserAreCountedOverAllServers) {
  const Member two(address_, folder_.path(), "two");
  ASSERT_TRUE(two.journal->create_session({"id-b", "b", "s", {7, 0.5}, 1, {}}, {}).is_ok());
  EXPECT_TRUE(one_->journal->charge("id-a", "ann", 1).is_ok());
  const Status refused = two.journal->charge("id-b", "ann", 1);
  EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
  EXPECT_THAT(refused.message(), HasSubstr("user ann on all servers: 1; limits.sessions_per_user"));
  EXPECT_TRUE(two.journal->charge("id-b", "bert", 1).is_ok());
  one_->journal->release("id-a");
  EXPECT_TRUE(one_->journal->roles("id-a").is_ok());  // behind the release
  EXPECT_TRUE(two.journal->charge("id-b", "ann", 1).is_ok());
}

TEST_F(MembershipTest, TheServerWithTheMostRoomIsKnownByItsHeartbeats) {
  Member two(address_, folder_.path(), "two"), three(address_, folder_.path(), "three");
  two.load = {"cpu", 1000, 300, 1};
  three.load = {"cpu", 1000, 900, 2};
  two.start();
  three.start();
  EXPECT_TRUE(Member::until([&] {
    const auto place = one_->journal->roomier_server(100).value();
    return place && place->node == "two";
  }));
  EXPECT_EQ(*one_->journal->roomier_server(100).value(), (ServerPlace{"two.lab:7411", "two"}));
  EXPECT_FALSE(one_->journal->roomier_server(700).value()) << "nobody has more";
  EXPECT_FALSE(two.journal->roomier_server(100).value()) << "the others have less";
}

TEST_F(MembershipTest, ADrainingServerGetsNoSessionAndGivesItsOwnToWhoeverAsks) {
  one_->load = {"cpu", 1000, 0, 1};
  one_->start();
  Member two(address_, folder_.path(), "two");
  two.load = {"cpu", 1000, 300, 1};
  two.start();
  EXPECT_TRUE(Member::until([&] {
    const auto place = two.journal->roomier_server(100).value();
    return place && place->node == "one" && one_->journal->roomier_server(100).value();
  }));
  EXPECT_FALSE(two.journal->hold("id-a").is_ok());
  const std::vector<FleetServer> others = one_->membership->drain();
  ASSERT_EQ(others.size(), 1u);
  EXPECT_EQ(others[0].place, (ServerPlace{"two.lab:7411", "two"}));
  EXPECT_EQ(others[0].bytes_free, 700u);
  EXPECT_FALSE(two.journal->roomier_server(100).value());
  EXPECT_TRUE(Member::until([&] { return two.fleet_size == 1; })) << "clients are not sent there";
  EXPECT_TRUE(two.membership->drain().empty()) << "a draining server takes nobody's sessions";
  EXPECT_TRUE(two.journal->hold("id-a").is_ok());
  const WriteOutcome late = one_->append(2);
  EXPECT_EQ(late.end(), End::kUnknown);
  EXPECT_EQ(one_->journal->hold("id-a").is_ok(), true) << "two drains as well";
}

TEST_F(MembershipTest, AnEditThatComesTooLateIsSentWhereTheSessionIs) {
  one_->start();
  Member two(address_, folder_.path(), "two");
  two.start();
  one_->membership->drain();
  ASSERT_TRUE(two.journal->hold("id-a").is_ok());
  EXPECT_EQ(ServerPlace::of(one_->append(2).why().moved_to()),
            (ServerPlace{"two.lab:7411", "two"}));
}

TEST_F(MembershipTest, ADrainingServerWhoseLifeWasEndedDrainsOn) {
  one_->start();
  one_->membership->drain();
  sql("DELETE FROM nodes");
  EXPECT_TRUE(Member::until([&] { return one_->lives == 2; }));
  PgConnection database = PgConnection::open(address_, {}, "test").value();
  std::string draining;
  EXPECT_TRUE(Member::until([&] {
    const PgReply row = database.run({"SELECT draining::text FROM nodes", {}}).value();
    if (row.rows() > 0) draining = row.bytes(0, 0);
    return row.rows() > 0;
  }));
  EXPECT_EQ(draining, "true");
}

TEST_F(MembershipTest, ADrainEndsWithoutTheDatabaseToo) {
  one_->start();
  EXPECT_TRUE(Member::until([this] { return one_->beats > 0; }));
  cluster_.kill();
  EXPECT_TRUE(one_->membership->drain().empty());
}

TEST_F(MembershipTest, ALeaseLastsFromTheLastHeartbeat) {
  one_->start();
  EXPECT_TRUE(Member::until([this] { return one_->beats > 2; }));
  EXPECT_TRUE(Member::until([this] { return one_->membership->lease_left().count() > 0; }));
  cluster_.kill();
  EXPECT_TRUE(Member::until([this] { return one_->membership->lease_left().count() < 0; }));
}

TEST_F(MembershipTest, SessionsOfADeadServerAreFreeWhenItsLeaseIsOver) {
  Member two(address_, folder_.path(), "two");
  EXPECT_FALSE(two.journal->hold("id-a").is_ok());
  two.start();
  EXPECT_TRUE(Member::until([&] { return two.journal->hold("id-a").is_ok(); }));
  EXPECT_GE(two.beats, 5) << "it must give others the time of a lease";
  EXPECT_EQ(one_->append(2).end(), End::kUnknown);
  EXPECT_TRUE(two.append(2).is_on_disk());
}

TEST_F(MembershipTest, ARestartedServerHasItsSessionsBackAtOnce) {
  one_->beating = {};
  sql("SELECT pg_terminate_backend(pid) FROM pg_stat_activity"
      " WHERE application_name LIKE 'burnish %-%'");  // as a kill does
                                                      // connections
  const Member again(address_, folder_.path(), "one");
  EXPECT_TRUE(again.journal->hold("id-a").is_ok());
  EXPECT_EQ(one_->append(2).end(), End::kUnknown);
  EXPECT_TRUE(again.append(2).is_on_disk());
}

TEST_F(MembershipTest, ANameOfARunningServerIsRefusedUntilItsLeaseIsOver) {
  one_->start();
  const auto join = [&] { return Membership::join(address_, {"one", "x.lab:7411"}, kShortTimes); };
  const Status refused = join().status();
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("'one'"));
  EXPECT_TRUE(one_->append(2).is_on_disk());
  one_->beating = {};  // it hangs
  EXPECT_TRUE(Member::until([&] { return join().is_ok(); }));
}

TEST_F(MembershipTest, SessionsOfAServerThatLeavesAreFreeAtOnce) {
  const Member two(address_, folder_.path(), "two");
  one_.reset();
  EXPECT_TRUE(two.journal->hold("id-a").is_ok());
}

TEST_F(MembershipTest, AReleasedSessionIsFreeAtOnce) {
  one_->start();
  const Member two(address_, folder_.path(), "two");
  one_->journal->release("id-a");
  EXPECT_EQ(one_->append(2).end(), End::kUnknown);
  EXPECT_TRUE(two.journal->hold("id-a").is_ok());
}

TEST_F(MembershipTest, AServerWhoseLifeWasEndedBeginsAnother) {
  one_->start();
  sql("DELETE FROM nodes");
  EXPECT_TRUE(Member::until([&] { return one_->lives == 2; }));
  EXPECT_EQ(one_->append(2).end(), End::kUnknown);
  EXPECT_TRUE(Member::until([&] { return one_->journal->hold("id-a").is_ok(); }));
  EXPECT_TRUE(one_->append(2).is_on_disk());
}

TEST_F(MembershipTest, TheLockOfAStoppedServerDoesNotHoldUpTheOthers) {
  Member two(address_, folder_.path(), "two");
  PgConnection stopped =
      PgConnection::open(address_, {}, "burnish " + one_->membership->first_life()).value();
  ASSERT_TRUE(stopped.script("BEGIN; SELECT 1 FROM sessions FOR UPDATE").is_ok());
  two.start();
  EXPECT_TRUE(Member::until([&] { return two.journal->hold("id-a").is_ok(); }));
  EXPECT_FALSE(stopped.script("COMMIT").is_ok());
}

TEST_F(MembershipTest, NobodyMovesAfterTheDatabaseWasAwayForLongerThanALease) {
  Member two(address_, folder_.path(), "two");
  one_->start();
  two.start();
  EXPECT_TRUE(Member::until([&] { return one_->beats > 10 && two.beats > 10; }));
  cluster_.kill();
  // The leases end by the database's clock.
  std::this_thread::sleep_for(2 * kShortTimes.lease);
  const int before = two.beats;
  cluster_.start();
  EXPECT_TRUE(Member::until([&] { return two.beats > before + 10; }));
  EXPECT_EQ(two.journal->hold("id-a").code(), StatusCode::kFailedPrecondition);
  EXPECT_EQ(one_->lives, 1);
  EXPECT_TRUE(one_->append(2).is_on_disk());
}

}  // namespace
}  // namespace burnish
