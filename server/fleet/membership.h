#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "common/base/server_place.h"
#include "server/fleet/node_rows.h"
#include "server/postgres/pg_connection.h"

namespace burnish {

struct LeaseTimes {
  std::chrono::milliseconds lease{10'000};
  std::chrono::milliseconds heartbeat{3'000};
  std::chrono::milliseconds alone{0};  ///< see HoldWatch
};

/// Another server of the fleet that takes sessions.
struct FleetServer {
  ServerPlace place;
  uint64_t bytes_free = 0;
};

/// The membership of a server in a fleet. Calls come from the thread that start() returns.
struct MemberDuties {
  /// This server's life was over, and another one has begun: it holds no session any more.
  std::function<void(const std::string& life)> on_new_life;
  /// Returns what a heartbeat tells of this server. Empty: nothing is told.
  std::function<NodeLoad()> load;
  /// After each heartbeat that succeeded, with the addresses of all servers that take sessions.
  std::function<void(std::vector<std::string> addresses)> on_heartbeat;
};

/// A server's place in a fleet, as a row with a lease. It renews the lease, and ends the lives of
/// servers whose leases are over: their sessions are free then. It ends others only after it has
/// renewed its own lease for as long as a lease lasts: when the database was away, all leases are
/// over, and the others get their time to renew them.
class Membership {
 public:
  /// Ends an earlier life of this name, so that a restarted server has its sessions back at once.
  /// Needs: the tables of the journal. Fails: failed_precondition (a server of this name has a
  /// lease and a connection); unavailable.
  static Result<std::unique_ptr<Membership>> join(const PgAddress& address, const NodeFacts& node,
                                                  const LeaseTimes& times);

  /// Leaves the fleet: the server's sessions are free at once.
  ~Membership();

  /// Renews the lease while the returned thread lives. Needs: one call; the thread ends before
  /// this.
  [[nodiscard]] std::jthread start(MemberDuties duties);

  /// Tells the fleet that this server ends: it gets no session any more, and others may take those
  /// that it has. Returns the other servers that take sessions. Waits for one heartbeat; returns
  /// nothing if that fails. Needs: the thread of start().
  std::vector<FleetServer> drain();

  /// Returns how long the lease lasts if no heartbeat succeeds any more; below 0: it is over.
  std::chrono::duration<double> lease_left() const;

  /// Returns the life that join() has begun.
  const std::string& first_life() const { return first_life_; }

 private:
  using Time = std::chrono::steady_clock::time_point;

  Membership(const PgAddress& address, const NodeFacts& node, const LeaseTimes& times,
             PgConnection connection, std::string life);

  void loop(const std::stop_token& stop);
  bool is_told_to_drain();
  void note_others(std::vector<FleetServer> others, bool has_told_drain);
  Status beat(bool is_draining);
  Status begin_another_life(const NodeLoad& load);
  Status reap(Time now);
  Status look_around(bool is_draining);

  const PgAddress address_;
  const NodeFacts node_;
  const LeaseTimes times_;
  const std::string first_life_;
  PgConnection connection_;
  std::string life_;
  std::optional<Time> good_since_;  // the first of the heartbeats in a row
  MemberDuties duties_;
  std::atomic<Time> renewed_;  // when the last heartbeat that succeeded was sent

  std::mutex mutex_;  // guards the following members
  std::condition_variable_any changed_;
  bool is_draining_ = false;
  bool has_told_drain_ = false;  // or has tried to
  std::vector<FleetServer> others_;
};

}  // namespace burnish
