#pragma once

#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "common/edit/edit.h"
#include "tests/server/postgres/postgres_cluster.h"
#include "tests/system/fleet_history.h"
#include "tests/system/server_process.h"

namespace burnish {

/// Two servers that share the session "work", and three clients that edit it through whichever
/// server takes their edits. Each sends an edit until it is acknowledged, then the next one.
class FaultyFleet {
 public:
  explicit FaultyFleet(uint32_t seed);

  /// Does one random fault while clients edit: kill -9 or SIGSTOP of a server, kill -9 of the
  /// database, or free_session(). Nothing waits for the pauses: they choose the moment.
  void fault();

  /// Frees the session under its owner's feet.
  void free_session() const;

  /// Ends the clients when all their edits are acknowledged.
  void stop_clients();

  /// Returns what is wrong in the journal. Needs: the clients are stopped.
  std::vector<std::string> violations() const { return history_.violations(address_); }
  size_t edits() const { return history_.acknowledged_edits(); }

 private:
  void edit(int client, const std::stop_token& stop);
  static Status apply(const ServerProcess& server, const Edit& edit);

  PostgresCluster cluster_{"fsync=off"};
  const std::string uri_ = cluster_.make_database();
  const PgAddress address_ = PgAddress::parse(uri_).value();
  const TemporaryFolder folder_;
  std::minstd_rand random_;
  std::vector<std::unique_ptr<ServerProcess>> servers_;
  FleetHistory history_;
  std::vector<std::jthread> clients_;  // end first
};

}  // namespace burnish
