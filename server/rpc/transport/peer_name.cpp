#include "server/rpc/transport/peer_name.h"

#include <cstring>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace burnish {

static std::string text_of(int family, const void* address) {
  char text[INET6_ADDRSTRLEN] = "";
  inet_ntop(family, address, text, sizeof(text));
  return text;
}

static Peer ipv4_peer(const void* address, int port) {
  const std::string host = text_of(AF_INET, address);
  return {"ipv4:" + host + ":" + std::to_string(port), host};
}

static Peer ipv6_peer(const sockaddr_in6& address) {
  const int port = ntohs(address.sin6_port);
  if (IN6_IS_ADDR_V4MAPPED(&address.sin6_addr))
    return ipv4_peer(&address.sin6_addr.s6_addr[12], port);
  std::string host = text_of(AF_INET6, &address.sin6_addr);
  // gRPC writes an address in the form of a URI. The link is part of it if the address is valid on
  // one link only.
  if (address.sin6_scope_id != 0) host += "%25" + std::to_string(address.sin6_scope_id);
  in6_addr network = address.sin6_addr;  // one party has the whole network
  std::memset(&network.s6_addr[8], 0, 8);
  return {"ipv6:%5B" + host + "%5D:" + std::to_string(port), text_of(AF_INET6, &network) + "/64"};
}

Peer peer_of_socket(int fd) {
  sockaddr_storage address = {};
  socklen_t length = sizeof(address);
  getpeername(fd, reinterpret_cast<sockaddr*>(&address), &length);
  if (address.ss_family == AF_INET) {
    const auto& ipv4 = reinterpret_cast<const sockaddr_in&>(address);
    return ipv4_peer(&ipv4.sin_addr, ntohs(ipv4.sin_port));
  }
  if (address.ss_family == AF_INET6) return ipv6_peer(reinterpret_cast<sockaddr_in6&>(address));
  return {"a local socket, " + std::to_string(fd), ""};
}

}  // namespace burnish
