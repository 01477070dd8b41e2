// A database with a standby that takes over. BURNISH_FAILOVERS=N does N failovers of each kind
// instead of one.

#include <csignal>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/connection/connection.h"
#include "server/postgres/pg_connection.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/environment.h"
#include "tests/system/fleet_config.h"
#include "tests/system/fleet_history.h"
#include "tests/system/server_process.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

PgAddress address_of(const std::string& uri) {
  return PgAddress::parse(uri).value();
}

/// A server whose journal is in one of two databases: a primary and its standby.
class Failover {
 public:
  explicit Failover(bool is_synchronous) : database_(primary_.make_database()) {
    if (is_synchronous) {
      on_primary("ALTER SYSTEM SET synchronous_standby_names = '*'");
      on_primary("SELECT pg_reload_conf()");
    }
    wait_for_standby(is_synchronous ? "sync" : "async");
    server_ =
        std::make_unique<ServerProcess>(fleet_flags(folder_, {.name = "one", .journal = uri()}));
    EXPECT_EQ(server_->burnish({"import", write_sphere(folder_), "--depth", "4", "--name", "ball"})
                  .exit_code,
              0);
    EXPECT_EQ(server_->burnish({"open", "ball", "--depth", "4", "--session", "work"}).exit_code, 0);
  }

  /// Sends an edit once. Returns whether it was acknowledged.
  bool send(int number, std::chrono::seconds patience) {
    const Edit edit{std::to_string(number), SetGradientScale{0.01 * number}};
    history_.sent(edit.id);
    auto connection = Connection::open(server_->address, patience);
    if (!connection.is_ok() || !connection->apply("work", {&edit, 1}).is_ok()) return false;
    history_.acknowledged(edit.id);
    return true;
  }

  void send_until_acknowledged(int number) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!send(number, std::chrono::seconds(5)) && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(milliseconds(50));
  }

  /// From now on the standby gets nothing, as behind a slow network.
  void hold_standby_up() {
    standby_.signal_all(SIGSTOP);
    on_primary("SELECT pg_terminate_backend(pid) FROM pg_stat_replication");
  }

  /// Returns when the journal's commit waits for the standby. Heartbeats wait as well.
  void wait_for_waiting_commit() {
    PgConnection database =
        PgConnection::open(address_of(primary_.uri("postgres")), {}, "test").value();
    static constexpr char kWaiting[] =
        "SELECT count(*) FROM pg_stat_activity WHERE wait_event = 'SyncRep'"
        " AND application_name LIKE 'burnish ________-%'";
    while (database.run({kWaiting, {}})->integer(0, 0) == 0)
      std::this_thread::sleep_for(milliseconds(20));
  }

  void lose_primary() {
    primary_.kill();
    standby_.signal_all(SIGCONT);
    standby_.promote();
  }

  std::vector<std::string> violations() const { return history_.violations(address_of(uri())); }
  size_t edits() const { return history_.acknowledged_edits(); }

 private:
  std::string uri() const {
    return database_ + "," + standby_.folder().string() + "&target_session_attrs=read-write";
  }

  void on_primary(const char* sql) {
    PgConnection database =
        PgConnection::open(address_of(primary_.uri("postgres")), {}, "test").value();
    EXPECT_TRUE(database.run({sql, {}}).is_ok()) << sql;
  }

  void wait_for_standby(const std::string& state) {
    PgConnection database =
        PgConnection::open(address_of(primary_.uri("postgres")), {}, "test").value();
    for (;;) {
      const auto now = database.run(
          {"SELECT sync_state FROM pg_stat_replication WHERE state = 'streaming'", {}});
      if (now->rows() == 1 && now->bytes(0, 0) == state) return;
      std::this_thread::sleep_for(milliseconds(20));
    }
  }

  PostgresCluster primary_{"fsync=off"};
  PostgresCluster standby_{primary_};
  const std::string database_;
  const TemporaryFolder folder_;
  std::unique_ptr<ServerProcess> server_;
  FleetHistory history_;
};

TEST(Failover, ToASynchronousStandbyLosesNoAcknowledgedEdit) {
  for (int round = 0; round < number_from_environment("BURNISH_FAILOVERS", 1); ++round) {
    Failover failover(true);
    for (int i = 0; i < 10; ++i) failover.send_until_acknowledged(i);
    failover.hold_standby_up();
    {
      const std::jthread sender([&] { failover.send_until_acknowledged(10); });
      failover.wait_for_waiting_commit();
      EXPECT_EQ(failover.edits(), 10u) << "only one host has the next one";
      failover.lose_primary();
    }
    for (int i = 11; i < 20; ++i) failover.send_until_acknowledged(i);
    EXPECT_EQ(failover.edits(), 20u);
    EXPECT_THAT(failover.violations(), testing::IsEmpty());
  }
}

// The control: what is documented as unsafe is seen to be unsafe.
TEST(Failover, ToAnAsynchronousStandbyLosesAcknowledgedEditsAndTheCheckerSaysSo) {
  for (int round = 0; round < number_from_environment("BURNISH_FAILOVERS", 1); ++round) {
    Failover failover(false);
    failover.send_until_acknowledged(0);
    failover.hold_standby_up();
    for (int i = 1; i < 10; ++i) EXPECT_TRUE(failover.send(i, kPatience));
    failover.lose_primary();
    failover.send_until_acknowledged(10);
    EXPECT_THAT(failover.violations(), testing::Contains(HasSubstr("is lost")));
  }
}

}  // namespace
}  // namespace burnish
