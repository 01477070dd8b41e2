// Servers that share a journal in PostgreSQL, as real processes over real gRPC. Whatever happens to
// one of them, another goes on with the same edits, and nobody's acknowledged edit is lost, doubled
// or out of order.

#include <csignal>
#include <fstream>
#include <map>
#include <set>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "server/postgres/pg_connection.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;
using testing::HasSubstr;

/// Two servers with a scan each, and a session "work" over it.
class FleetTest : public testing::Test {
 protected:
  FleetTest() {
    for (const char* name : {"one", "two"}) {
      servers_[name] = std::make_unique<ServerProcess>(flags_of(name));
      ServerProcess& server = *servers_[name];
      server.listen = server.address;
      EXPECT_EQ(server.burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                    .exit_code,
                0);
    }
    EXPECT_EQ(one().burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  }

  /// Leases are short: the database has their clock, and the tests wait for it.
  std::vector<std::string> flags_of(const std::string& name) {
    const auto path = folder_ / (name + ".toml");
    std::ofstream(path) << "journal = \"" << uri_ << "\"\n[fleet]\nname = \"" << name
                        << "\"\nlease_ms = 1500\nheartbeat_ms = 300\n";
    return {"--config", path.string()};
  }

  ServerProcess& one() { return *servers_["one"]; }
  ServerProcess& two() { return *servers_["two"]; }

  /// Applies a slider of this number until somebody knows it; notes that it was acknowledged.
  Status slide(ServerProcess& server, int number) {
    auto connection = Connection::open(server.address, std::chrono::seconds(5));
    RETURN_IF_ERROR(connection.status());
    const Edit edit{std::to_string(number), SetGradientScale{0.01 * number}};
    RETURN_IF_ERROR(connection->apply("work", {&edit, 1}).status());
    acknowledged_.push_back(edit.id);
    return Status::ok();
  }

  /// Does the same until it succeeds. Returns the seconds that it took.
  double slide_until_taken(ServerProcess& server, int number) {
    const auto begin = steady_clock::now();
    Status status = slide(server, number);
    while (!status.is_ok() && steady_clock::now() < begin + kPatience) {
      std::this_thread::sleep_for(milliseconds(20));
      status = slide(server, number);
    }
    EXPECT_TRUE(status.is_ok()) << status.message();
    return std::chrono::duration<double>(steady_clock::now() - begin).count();
  }

  /// Checks the recorded history: each acknowledged edit is there once, and those that were sent
  /// after an acknowledgement come behind it.
  void check_history(ServerProcess& server) {
    Connection connection = Connection::open(server.address, kPatience).value();
    const std::vector<HistoryEntry> history = connection.history("work").value();
    std::vector<std::string> ids;
    uint64_t number = 0;
    for (const HistoryEntry& entry : history) {
      EXPECT_EQ(entry.number, ++number);
      ids.push_back(entry.edit_id);
    }
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size());
    size_t at = 0;
    for (const std::string& id : acknowledged_) {
      while (at < ids.size() && ids[at] != id) ++at;
      EXPECT_LT(at, ids.size()) << "edit " << id << " is lost or out of order";
    }
  }

  std::string exported(ServerProcess& server) {
    const std::string file = (folder_ / "out.ply").string();
    const CommandOutcome outcome = server.burnish({"export", "work", file, "--exact"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    return content_of(file);
  }

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const TemporaryFolder folder_;
  std::map<std::string, std::unique_ptr<ServerProcess>> servers_;
  std::vector<std::string> acknowledged_;
};

TEST_F(FleetTest, AnotherServerGoesOnWhenTheOwnerIsKilled) {
  for (int i = 1; i <= 5; ++i) ASSERT_TRUE(slide(one(), i).is_ok());
  const std::string before = exported(one());
  const Status refused = slide(two(), 6);
  EXPECT_EQ(refused.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(refused.message(), HasSubstr("server one"));
  one().kill();
  const auto begin = steady_clock::now();
  while (two().burnish({"history", "work"}).exit_code != 0 &&
         steady_clock::now() < begin + kPatience) {
  }
  EXPECT_EQ(exported(two()), before);
  const double taken_s = slide_until_taken(two(), 6);
  EXPECT_LT(taken_s, 60);
  check_history(two());
}

TEST_F(FleetTest, AKilledServerIsBackAtOnceAfterItsRestart) {
  for (int i = 1; i <= 3; ++i) ASSERT_TRUE(slide(one(), i).is_ok());
  one().kill();
  one().start();
  EXPECT_TRUE(slide(one(), 4).is_ok()) << "it does not wait for its own dead life";
  check_history(one());
}

TEST_F(FleetTest, ADrainedServerHandsItsSessionsOverAtOnce) {
  for (int i = 1; i <= 3; ++i) ASSERT_TRUE(slide(one(), i).is_ok());
  one().process->signal(SIGTERM);
  EXPECT_EQ(one().process->wait(kPatience), 0);
  EXPECT_TRUE(slide(two(), 4).is_ok());
  check_history(two());
}

TEST_F(FleetTest, AStoppedServerThatGoesOnIsFenced) {
  for (int i = 1; i <= 3; ++i) ASSERT_TRUE(slide(one(), i).is_ok());
  one().process->signal(SIGSTOP);
  slide_until_taken(two(), 4);
  one().process->signal(SIGCONT);
  EXPECT_FALSE(slide(one(), 5).is_ok());
  slide_until_taken(two(), 6);
  check_history(two());
}

TEST_F(FleetTest, EditsGoOnAfterTheDatabaseWasKilled) {
  for (int i = 1; i <= 20; ++i) {
    if (i % 5 == 0) {
      cluster_.kill();
      std::jthread starter([this] { cluster_.start(); });
      slide_until_taken(one(), i);
    } else {
      slide_until_taken(one(), i);
    }
  }
  check_history(one());
}

TEST_F(FleetTest, TwoServersThatFightForASessionLoseNothing) {
  for (int i = 1; i <= 24; ++i) {
    // Somebody frees the session under its owner's feet.
    auto database = PgConnection::open(PgAddress::parse(uri_).value(), {}, "test");
    ASSERT_TRUE(database.is_ok());
    ASSERT_TRUE(database->script("UPDATE sessions SET owner = NULL").is_ok());
    slide_until_taken(i % 2 ? two() : one(), i);
  }
  // Edit 24 was one's: it has the session.
  check_history(one());
}

}  // namespace
}  // namespace burnish
