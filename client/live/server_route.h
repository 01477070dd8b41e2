#pragma once

#include <string>
#include <vector>

#include "client/live/live_mutex.h"

namespace burnish {

/// Limit of servers that a call is sent on to, one after the other. A session that moves more often
/// is waited for.
inline constexpr int kMovesMax = 5;

/// The address at which a session's server is reached. A session may move to another server of a
/// fleet; all that talk about it share this. Thread-safe.
class ServerRoute {
 public:
  explicit ServerRoute(std::string address) : address_(std::move(address)) {}

  std::string address() const;

  /// A server has said that the one at `address` has the session.
  void move_to(const std::string& address);
  /// Takes the addresses of all servers of the fleet; empty: there is no fleet.
  void learn(std::vector<std::string> fleet);
  /// The server at `address` does not answer or ends: goes on to the next one of the fleet. Does
  /// nothing if the way leads elsewhere already, or there is no other.
  void give_up(const std::string& address);

 private:
  mutable LiveMutex mutex_;  // of what follows
  std::string address_;
  std::vector<std::string> fleet_;
};

}  // namespace burnish
