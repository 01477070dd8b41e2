#pragma once

#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include <grpcpp/server_builder.h>

#include "server/rpc/listening_socket.h"

namespace burnish {

/// Accepts connections and hands them to gRPC, up to a limit. gRPC 1.51 knows no such limit, and
/// stops listening for good when the process runs out of file descriptors.
class ConnectionAcceptor {
 public:
  using Receiver = std::shared_ptr<grpc::experimental::ExternalConnectionAcceptor>;

  explicit ConnectionAcceptor(size_t connections_max) : connections_max_(connections_max) {}
  ~ConnectionAcceptor() { stop(); }

  /// Connections to `socket` go to `receiver`. Needs: not started.
  void add(ListeningSocket socket, Receiver receiver);

  /// Needs: the gRPC server runs.
  void start();

  /// That clients and gRPC still hold.
  size_t open_connections();

  /// Stops listening; connections that are there stay. Idempotent.
  void stop();

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
  };

  void run();
  void accept_from(Door& door);
  void forget_closed();  // needs the lock

  const size_t connections_max_;
  std::vector<Door> doors_;
  std::mutex mutex_;  // of connections_
  std::vector<Connection> connections_;
  int wake_ = -1;
  std::thread thread_;
};

}  // namespace burnish
