#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include <grpcpp/server_builder.h>

#include "server/rpc/listening_socket.h"

namespace burnish {

struct ConnectionLimits {
  size_t connections_max = 256;
  size_t connections_per_peer = 64;      ///< of one address over TCP; of IPv6, one /64 network
  std::chrono::seconds silence_max{30};  ///< until a call of the connection is let in
};

/// Accepts connections and hands them to gRPC, up to limits. gRPC 1.51 knows no such limits, and
/// stops listening for good when the process runs out of file descriptors. Over TCP a connection of
/// which no call is let in for `silence_max` is closed. Thread-safe.
class ConnectionAcceptor {
 public:
  using Receiver = std::shared_ptr<grpc::experimental::ExternalConnectionAcceptor>;

  explicit ConnectionAcceptor(const ConnectionLimits& limits) : limits_(limits) {}
  ~ConnectionAcceptor() { stop(); }

  /// Connections to `socket` go to `receiver`. Needs: not started.
  void add(ListeningSocket socket, Receiver receiver);

  /// Needs: the gRPC server runs.
  void start();

  /// That clients and gRPC still hold.
  size_t open_connections();

  /// Stops listening; connections that are there stay. Idempotent.
  void stop();

  /// A call of this peer has been let in; as gRPC writes it: "ipv4:127.0.0.1:5000".
  void note_call(const std::string& peer);

 private:
  struct Door {
    ListeningSocket socket;
    Receiver receiver;
  };
  /// A connection that was handed over: gRPC owns its descriptor, the inode tells whether that
  /// number is still this connection.
  struct Connection {
    int fd;
    uint64_t inode;
    std::string host;  // empty: a Unix socket
    std::chrono::steady_clock::time_point since;
    bool is_known;  // a call was let in, or it need not be
  };
  using Connections = std::unordered_map<std::string, Connection>;  // by peer

  void run();
  void accept_from(Door& door);
  std::string refusal(const std::string& host);
  void forget_closed();
  void close_silent();
  bool has_unknown();

  const ConnectionLimits limits_;
  std::vector<Door> doors_;
  std::mutex mutex_;  // of connections_
  Connections connections_;
  std::chrono::steady_clock::time_point last_sweep_;
  int wake_ = -1;
  std::thread thread_;
};

}  // namespace burnish
