#pragma once

#include <string>
#include <vector>

#include "client/live/live_mutex.h"
#include "common/base/server_place.h"

namespace burnish {

/// Limit of servers that a call is sent on to, one after the other. A session that moves more often
/// is waited for.
inline constexpr int kMovesMax = 5;

/// The address of a session's server. A session may move to another server of a fleet; all
/// that talk about it share this. Thread-safe.
class ServerRoute {
 public:
  explicit ServerRoute(std::string address) : place_{std::move(address), {}} {}

  /// Returns an address, and the name of the server if a server has told it.
  ServerPlace place() const;
  std::string address() const { return place().address; }

  /// A server has said that the one at `place` has the session. Without an address it is behind the
  /// proxy at the present one.
  void move_to(const ServerPlace& place);
  /// Takes the addresses of all servers of the fleet; empty: there is no fleet.
  void learn(std::vector<std::string> fleet);
  /// The server at `address` does not answer or ends: goes on to the next one of the fleet, or lets
  /// a proxy choose if the fleet's addresses are not known. Does nothing if the way leads elsewhere
  /// already.
  void give_up(const std::string& address);

 private:
  mutable LiveMutex mutex_;  // of what follows
  ServerPlace place_;
  std::vector<std::string> fleet_;
};

}  // namespace burnish
