#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_map>
#include <vector>

#include "server/rpc/transport/listening_socket.h"

namespace burnish {

struct ConnectionLimits {
  size_t connections_max = 256;
  size_t connections_per_peer = 64;      ///< of one address over TCP; for IPv6, of one /64 network
  std::chrono::seconds silence_max{30};  ///< until a call of the connection is admitted
};

/// Accepts connections and hands them to gRPC and the web gateway, up to limits that both share.
/// gRPC 1.51 has no such limits, and stops listening for good when the process runs out of file
/// descriptors. Closes a TCP connection if no call of it is admitted for `silence_max`. Where all
/// places are taken, a new connection gets that of the oldest without an admitted call: strangers
/// keep nobody out.
/// Thread-safe.
class ConnectionAcceptor {
 public:
  /// Takes over a connected socket.
  using Receiver = std::function<void(int listening_fd, int fd, const std::string& peer)>;

  /// Says who closes connections without an admitted call.
  enum class Silence { kAcceptor, kReceiver };

  explicit ConnectionAcceptor(const ConnectionLimits& limits) : limits_(limits) {}
  ~ConnectionAcceptor() { stop(); }

  /// Hands connections to `socket` to `receiver`. Needs: not started.
  void add(ListeningSocket socket, Receiver receiver, Silence silence = Silence::kAcceptor);

  /// Needs: the receivers run.
  void start();

  /// Returns the connections that clients and receivers still hold.
  size_t open_connections();

  /// Stops listening; existing connections stay. Idempotent.
  void stop();

  /// Notes that a call of this peer was admitted that is not open to all, in gRPC's form:
  /// "ipv4:127.0.0.1:5000".
  void note_call(const std::string& peer);

 private:
  struct Listener {
    ListeningSocket socket;
    Receiver receiver;
    Silence silence;
  };
  /// A connection that its receiver has taken over. The receiver owns its descriptor; the inode
  /// says whether the number still belongs to this connection.
  struct Connection {
    int fd;
    uint64_t inode;
    std::string host;  // empty for a Unix socket
    std::chrono::steady_clock::time_point since;
    bool is_admitted;  // a call was, or none is needed
    Silence silence;   // who closes it before

    bool waits_for_call() const { return !is_admitted && silence == Silence::kAcceptor; }
  };
  using Connections = std::unordered_map<std::string, Connection>;  // by peer

  void run();
  void accept_from(Listener& listener);
  std::string refusal(const std::string& host);
  void make_room();
  void forget_closed();
  void close_silent();
  bool has_unknown();

  const ConnectionLimits limits_;
  std::vector<Listener> listeners_;
  std::mutex mutex_;  // guards connections_ and leaving_
  Connections connections_;
  std::vector<Connection> leaving_;  // had to make room; their receivers have yet to close them
  std::chrono::steady_clock::time_point last_sweep_;
  int wake_ = -1;
  std::thread thread_;
};

}  // namespace burnish
