// One server of a fleet loses the way to the database, and the other does not. Its clients hear so
// before anybody else can have their sessions, and go on at the other one.

#include <memory>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/session_link.h"
#include "server/postgres/pg_connection.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/fetched_pages.h"
#include "tests/system/fleet_config.h"
#include "tests/system/link.h"
#include "tests/system/live_stream.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;

/// Server "one" reaches the database through a link, "two" without it. "one" has the session
/// "work". The database has the clock of leases, so the tests wait for it.
class FleetPartition : public testing::Test {
 protected:
  FleetPartition() : one_(make("one", journal_of_one())), two_(make("two", uri_)) {
    EXPECT_EQ(one_->burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  }

  std::string journal_of_one() const {
    const std::string database = uri_.substr(uri_.rfind('/', uri_.find('?')) + 1);
    return "postgresql://burnish@" + way_.address() + "/" + database.substr(0, database.find('?'));
  }

  /// Starts a server, learns its port, and starts it again as one that advertises it.
  std::unique_ptr<ServerProcess> make(const std::string& name, const std::string& journal) {
    FleetServer facts{.name = name, .journal = journal, .lease_ms = 4000, .heartbeat_ms = 500};
    auto server = std::make_unique<ServerProcess>(fleet_flags(folder_, facts));
    EXPECT_EQ(server->burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                  .exit_code,
              0);
    server->kill();
    server->listen = facts.advertise = server->address;
    fleet_flags(folder_, facts);
    server->start();
    return server;
  }

  /// Returns the name of the server that has the session, by the database.
  std::string owner() const {
    PgConnection database = PgConnection::open(PgAddress::parse(uri_).value(), {}, "test").value();
    const PgReply row =
        database.run({"SELECT nodes.name FROM sessions LEFT JOIN nodes ON nodes.id = owner", {}})
            .value();
    return row.bytes(0, 0);
  }

  static Status slide(const ServerProcess& server, const std::string& id) {
    Connection connection = Connection::open(server.address, kPatience).value();
    const Edit edit{id, SetGradientScale{2}};
    return connection.apply("work", {&edit, 1}).status();
  }

  /// Greets "one" until a heartbeat has told it of the other server.
  void wait_until_one_knows_two() const {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    int known = 0;
    while (known < 2 && std::chrono::steady_clock::now() < end) {
      LiveStream stream(grpc::CreateChannel(one_->address, grpc::InsecureChannelCredentials()));
      stream.greet("work");
      known = stream.next(v1::ServerMessage::kWelcome).welcome().fleet_size();
    }
    EXPECT_EQ(known, 2);
  }

  /// Tries until the server takes the edit.
  static void slide_until_taken(const ServerProcess& server, const std::string& id) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!slide(server, id).is_ok() && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(milliseconds(50));
  }

  std::vector<std::string> history() const {
    Connection connection = Connection::open(two_->address, kPatience).value();
    const std::vector<HistoryEntry> entries = connection.history("work").value();
    std::vector<std::string> ids;
    for (const HistoryEntry& entry : entries) ids.push_back(entry.edit_id);
    return ids;
  }

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  Link way_{(cluster_.folder() / ".s.PGSQL.5432").string(), {1000, std::chrono::microseconds(0)}};
  const TemporaryFolder folder_;
  std::unique_ptr<ServerProcess> one_, two_;
};

TEST_F(FleetPartition, ItsClientsAreSentAwayBeforeAnybodyElseCanHaveTheSession) {
  LiveStream stream(grpc::CreateChannel(one_->address, grpc::InsecureChannelCredentials()));
  stream.greet("work");
  stream.slide("a", 0.5);
  stream.next(v1::ServerMessage::kAcknowledged);
  way_.stall(true);
  stream.slide("b", 2);
  stream.seen.clear();
  const v1::GoAway go_away = stream.next(v1::ServerMessage::kGoAway).go_away();
  EXPECT_EQ(owner(), "one");
  EXPECT_EQ(go_away.code(), v1::GO_AWAY_CODE_NOT_OWNER);
  EXPECT_TRUE(go_away.come_back());
  EXPECT_THAT(go_away.reason(), testing::HasSubstr("does not reach the database"));
  for (const v1::ServerMessage& message : stream.seen)
    EXPECT_FALSE(message.has_acknowledged() || message.has_refused()) << message.DebugString();
  EXPECT_EQ(slide(*one_, "late").code(), StatusCode::kUnavailable);
  slide_until_taken(*two_, "b");
  EXPECT_EQ(owner(), "two");
  // The fence stops writes that were on their way, and the server learns where its session is.
  way_.stall(false);
  slide_until_taken(*one_, "c");
  EXPECT_THAT(history(), ElementsAre("a", "b", "c"));
  EXPECT_EQ(owner(), "two");
}

TEST_F(FleetPartition, ALiveLinkGoesOnAtTheServerThatReachesTheDatabase) {
  Connection connection = Connection::open(one_->address, kPatience).value();
  const FetchedPages pages = fetch_all_pages(connection, "ball");
  LiveOptions options = pages.live_options("work", 4);
  options.retry_after_min = milliseconds(20);
  options.retry_after_max = milliseconds(200);
  SessionLink link(connection, options);
  ASSERT_TRUE(link.apply({Edit{"a", SetGradientScale{0.5}}}).is_ok());
  ASSERT_TRUE(link.wait_until_acknowledged(kPatience));
  wait_until_one_knows_two();
  way_.stall(true);
  ASSERT_TRUE(link.apply({Edit{"b", SetGradientScale{2}}}).is_ok());
  ASSERT_TRUE(link.wait_until_acknowledged(kPatience));
  EXPECT_THAT(history(), ElementsAre("a", "b"));
  EXPECT_EQ(owner(), "two");
  EXPECT_NE(link.take().link, LinkState::kEnded);
}

}  // namespace
}  // namespace burnish
