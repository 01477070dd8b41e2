#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "common/base/status.h"

namespace burnish {

class Executor;
class MeshStore;
class SessionManager;

/// The listening service: Library, Editing, health and reflection.
class Server {
 public:
  /// Listens on `listen` (HOST:PORT, port 0: a free one) and serves at once.
  /// Needs: store, sessions and executor outlive the server.
  /// Fails: unavailable when the address cannot be bound.
  static Result<std::unique_ptr<Server>> start(const std::string& listen, MeshStore& store,
                                               SessionManager& sessions, Executor& executor);
  ~Server();

  /// HOST:PORT with the port that was chosen.
  const std::string& address() const;
  int port() const;

  /// Reports NOT_SERVING, takes no new calls, lets those under way end until the time is over,
  /// cancels the rest and returns when they have ended.
  void drain(std::chrono::milliseconds time);

 private:
  struct State;
  explicit Server(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish
