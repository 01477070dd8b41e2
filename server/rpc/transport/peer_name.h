#pragma once

#include <string>

namespace burnish {

/// The other end of a connected socket.
struct Peer {
  /// "ipv4:127.0.0.1:5000" or "ipv6:%5B::1%5D:5000", as gRPC writes it; or unique
  std::string name;
  /// network of one party: "127.0.0.1", "2001:db8::/64"; empty for a Unix socket
  std::string host;
};

Peer peer_of_socket(int fd);

}  // namespace burnish
