#pragma once

#include <string>

namespace burnish {

/// Who is at the other end of a connected socket.
struct Peer {
  std::string name;  ///< "ipv4:127.0.0.1:5000" or "ipv6:%5B::1%5D:5000", as gRPC says it; or unique
  std::string host;  ///< what one party has: "127.0.0.1", "2001:db8::/64"; empty: a Unix socket
};

Peer peer_of_socket(int fd);

}  // namespace burnish
