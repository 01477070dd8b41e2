// Two servers and their database under random faults, while clients edit through whichever server
// takes their edits: kill -9 and SIGSTOP of servers, kill -9 of PostgreSQL, sessions that are freed
// under their owner's feet. A checker reads the recorded history.
// BURNISH_FLEET_ROUNDS=N does N faults instead of 5.

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "server/postgres/pg_connection.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/environment.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;

/// When an edit was first sent, and acknowledged: by one counter for all clients.
struct EditTimes {
  uint64_t sent = 0, acknowledged = 0;
};

/// Two servers that share the session "work", and clients that edit it.
class FaultyFleet {
 public:
  explicit FaultyFleet(uint32_t seed) : random_(seed) {
    const std::string scan = write_sphere(folder_);
    for (const char* name : {"one", "two"}) {
      const auto path = folder_ / (std::string(name) + ".toml");
      std::ofstream(path) << "journal = \"" << uri_ << "\"\n[fleet]\nname = \"" << name
                          << "\"\nlease_ms = 1000\nheartbeat_ms = 200\n";
      auto& server = servers_.emplace_back(
          std::make_unique<ServerProcess>(std::vector<std::string>{"--config", path.string()}));
      server->listen = server->address;
      EXPECT_EQ(server->burnish({"import", scan, "--depth", "4", "--name", "ball"}).exit_code, 0);
    }
    EXPECT_EQ(servers_[0]->burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code,
              0);
    for (int i = 0; i < 3; ++i)
      clients_.emplace_back([this, i](const std::stop_token& stop) { edit(i, stop); });
  }

  /// Does one fault while clients edit. Nothing waits for the pauses: they choose the moment.
  void fault() {
    std::this_thread::sleep_for(milliseconds(random_() % 1000));
    ServerProcess& server = *servers_[random_() % servers_.size()];
    switch (random_() % 4) {
      case 0:
        server.kill();
        server.start();
        break;
      case 1:
        server.process->signal(SIGSTOP);
        std::this_thread::sleep_for(milliseconds(500 + random_() % 2000));
        server.process->signal(SIGCONT);
        break;
      case 2:
        cluster_.kill();
        cluster_.start();
        break;
      default:
        free_session();
    }
  }

  /// Ends the clients when all their edits are acknowledged, and checks the history.
  void check() {
    for (std::jthread& client : clients_) client.request_stop();
    clients_.clear();
    const std::vector<std::string> ids = recorded();
    EXPECT_EQ(ids.size(), times_.size()) << "edits are lost or doubled";
    for (const auto& [id, times] : times_)
      EXPECT_EQ(std::ranges::count(ids, id), 1) << "edit " << id;
    // From the end: nothing may stand before an edit that was acknowledged before it was sent.
    uint64_t first_acknowledged = UINT64_MAX;
    for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
      EXPECT_LT(times_[*id].sent, first_acknowledged) << "edit " << *id << " is out of order";
      first_acknowledged = std::min(first_acknowledged, times_[*id].acknowledged);
    }
    EXPECT_EQ(count("SELECT count(*) FROM (SELECT number - row_number() OVER (ORDER BY number) AS"
                    " gap FROM edits) AS gaps WHERE gap <> 0"),
              0);
    EXPECT_EQ(count("SELECT count(*) FROM (SELECT epoch - lag(epoch) OVER (ORDER BY number) AS"
                    " step FROM edits) AS steps WHERE step < 0"),
              0)
        << "two owners wrote at once";
    EXPECT_EQ(count("SELECT edits FROM sessions"), static_cast<int64_t>(ids.size()));
  }

  size_t edits() const { return times_.size(); }

 private:
  /// Sends one edit after the other until it is acknowledged, to any server.
  void edit(int client, const std::stop_token& stop) {
    std::minstd_rand random(static_cast<uint32_t>(client + 1));
    for (int number = 0; !stop.stop_requested(); ++number) {
      const Edit edit{std::to_string(client) + "-" + std::to_string(number),
                      SetGradientScale{0.01 * (number % 100)}};
      note(edit.id, &EditTimes::sent);
      while (!apply(*servers_[random() % servers_.size()], edit).is_ok())
        std::this_thread::sleep_for(milliseconds(20));
      note(edit.id, &EditTimes::acknowledged);
    }
  }

  static Status apply(const ServerProcess& server, const Edit& edit) {
    auto connection = Connection::open(server.listen, std::chrono::seconds(2));
    return connection.is_ok() ? connection->apply("work", {&edit, 1}).status()
                              : connection.status();
  }

  void note(const std::string& id, uint64_t EditTimes::*when) {
    const std::lock_guard lock(mutex_);
    times_[id].*when = ++clock_;
  }

  PgConnection database() const {
    return PgConnection::open(PgAddress::parse(uri_).value(), {}, "test").value();
  }

  void free_session() const {
    EXPECT_TRUE(database().script("UPDATE sessions SET owner = NULL").is_ok());
  }

  int64_t count(const char* query) const {
    PgConnection connection = database();
    return connection.run({query, {}})->integer(0, 0);
  }

  std::vector<std::string> recorded() const {
    PgConnection connection = database();
    const PgReply reply = connection.run({"SELECT id FROM edits ORDER BY number", {}}).value();
    std::vector<std::string> ids;
    for (size_t row = 0; row < reply.rows(); ++row) ids.push_back(reply.bytes(row, 0));
    return ids;
  }

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const TemporaryFolder folder_;
  std::minstd_rand random_;
  std::vector<std::unique_ptr<ServerProcess>> servers_;

  std::mutex mutex_;  // guards the following members while clients edit
  std::map<std::string, EditTimes> times_;
  uint64_t clock_ = 0;

  std::vector<std::jthread> clients_;  // end first
};

TEST(FaultyFleet, LosesDoublesAndMisordersNoAcknowledgedEdit) {
  const int rounds = number_from_environment("BURNISH_FLEET_ROUNDS", 5);
  FaultyFleet fleet(1);
  for (int i = 0; i < rounds; ++i) fleet.fault();
  fleet.check();
  EXPECT_GT(fleet.edits(), 0u);
  std::cout << rounds << " faults, " << fleet.edits() << " edits, each of them there once\n";
}

}  // namespace
}  // namespace burnish
