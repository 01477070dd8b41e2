#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "common/base/status.h"
#include "server/live/successors.h"
#include "server/rpc/transport/connection_acceptor.h"
#include "server/trust/certificates.h"
#include "server/trust/reloaded.h"
#include "server/trust/users.h"

namespace burnish {

class Pools;
class LiveSessions;
class MeshStore;
class SessionManager;
struct WebCalls;

struct ServerOptions {
  std::string listen;             ///< HOST:PORT, port 0 for a free port; empty: no TCP
  std::filesystem::path socket;   ///< a Unix socket in addition; empty: none
  bool socket_user_only = false;  ///< its mode: 0600, else 0660
  const Reloaded<Certificates>* certificates = nullptr;  ///< null: TCP in plain text
  bool client_certificate_required = true;               ///< if the certificates have a CA
  const Reloaded<UserTable>* users = nullptr;            ///< null: no authentication
  std::string web;                                       ///< HOST:PORT for browsers; empty: none
  std::vector<std::string> web_hosts;  ///< names of this server besides the host of `web`
  ConnectionLimits connections;
  uint64_t streams_per_user = 64;
  std::chrono::seconds upload_silence_max{30};  ///< for a client that announced more data
};

/// The listening service: Library, Editing, health and reflection.
class Server {
 public:
  /// Listens and serves at once. Needs: store, sessions, live, pools and the objects in the options
  /// outlive the server. Fails: unavailable if an address cannot be bound.
  static Result<std::unique_ptr<Server>> start(const ServerOptions& options, MeshStore& store,
                                               SessionManager& sessions, LiveSessions& live,
                                               Pools& pools);
  ~Server();

  /// HOST:PORT with the chosen port, else unix:PATH.
  const std::string& address() const;
  int port() const;  ///< 0 without TCP

  /// "https://HOST:PORT" with the chosen port; empty without a web gateway.
  const std::string& web_address() const;

  /// Returns the connections that the web gateway holds; 0 without a gateway.
  size_t web_connections() const;

  /// Sets the answer of the health service for the server and each of its services.
  void set_serving(bool serving);

  /// Returns the running calls of Burnish's services.
  int64_t running_calls() const;

  /// Returns whether somebody is connected, or a call of Burnish's services is running.
  bool is_in_use() const;

  /// Returns the new calls that ended before their first message was whole: it was above the
  /// receive limit, or the client is gone. Call about every half second. A message that is still on
  /// its way counts only after several calls.
  uint64_t take_cut_off_calls();

  /// Reports NOT_SERVING and admits no call. Lets running calls end for `time`, cancels the rest
  /// and returns when they have ended.
  void drain(std::chrono::milliseconds time, Successors successors = {});

 private:
  struct State;
  Status open_web(const ServerOptions& options, WebCalls calls);
  explicit Server(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace burnish
