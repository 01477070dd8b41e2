#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "common/base/status.h"
#include "server/rpc/connection_acceptor.h"
#include "server/trust/certificates.h"
#include "server/trust/reloaded.h"
#include "server/trust/users.h"

namespace burnish {

class Lanes;
class LiveSessions;
class MeshStore;
class SessionManager;

struct ServerOptions {
  std::string listen;             ///< HOST:PORT, port 0 a free one; empty: no TCP
  std::filesystem::path socket;   ///< a Unix socket as well; empty: none
  bool socket_user_only = false;  ///< its mode: 0600, else 0660
  const Reloaded<Certificates>* certificates = nullptr;  ///< null: TCP in plain text
  bool client_certificate_required = true;               ///< where the certificates have a CA
  const Reloaded<UserTable>* users = nullptr;            ///< null: nobody is asked who he is
  ConnectionLimits connections;
  uint64_t streams_per_user = 64;
  std::chrono::seconds upload_silence_max{30};  ///< of who has announced more to send
};

/// The listening service: Library, Editing, health and reflection.
class Server {
 public:
  /// Listens and serves at once.
  /// Needs: store, sessions, live, lanes and what the options point to outlive the server.
  /// Fails: unavailable when an address cannot be bound.
  static Result<std::unique_ptr<Server>> start(const ServerOptions& options, MeshStore& store,
                                               SessionManager& sessions, LiveSessions& live,
                                               Lanes& lanes);
  ~Server();

  /// HOST:PORT with the port that was chosen, else unix:PATH.
  const std::string& address() const;
  int port() const;  ///< 0 without TCP

  /// What the health service says of the server and of each of its services.
  void set_serving(bool serving);

  /// Calls of our services under way.
  int64_t running_calls() const;

  /// Somebody is connected, or a call of our services is under way.
  bool is_in_use() const;

  /// Calls that have ended before their first message was whole since the last time: the message
  /// was above the receive limit, or its client has gone. To be asked every half second or so;
  /// what is still on its way is not counted until it has been for a few times.
  uint64_t take_cut_off_calls();

  /// Reports NOT_SERVING, lets no call in, lets those under way end until the time is over,
  /// cancels the rest and returns when they have ended.
  void drain(std::chrono::milliseconds time);

 private:
  struct State;
  explicit Server(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish
