#include "server/rpc/transport/peer_name.h"

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "server/rpc/transport/listening_socket.h"

namespace burnish {
namespace {

/// Returns the peer of a connection that a server has accepted at `to`, the loopback of a family.
Peer peer_at(const ListeningSocket& server, sockaddr_storage to, socklen_t length) {
  const int client = socket(to.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  EXPECT_EQ(connect(client, reinterpret_cast<const sockaddr*>(&to), length), 0);
  const int accepted = accept4(server.fd(), nullptr, nullptr, SOCK_CLOEXEC);
  EXPECT_GE(accepted, 0);
  const Peer peer = peer_of_socket(accepted);
  close(client);
  close(accepted);
  return peer;
}

Peer peer_over_ipv4(const ListeningSocket& server) {
  sockaddr_storage to = {};
  auto& address = reinterpret_cast<sockaddr_in&>(to);
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<uint16_t>(server.port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return peer_at(server, to, sizeof(address));
}

TEST(PeerName, OfIpv4IsAsGrpcSaysIt) {
  const auto server = ListeningSocket::tcp("127.0.0.1:0");
  const Peer peer = peer_over_ipv4(server.value());
  EXPECT_THAT(peer.name, testing::MatchesRegex("ipv4:127\\.0\\.0\\.1:[0-9]+"));
  EXPECT_EQ(peer.host, "127.0.0.1");
}

TEST(PeerName, OfIpv4AtASocketOfBothFamiliesIsTheSame) {
  const auto server = ListeningSocket::tcp("[::]:0");
  if (!server.is_ok()) GTEST_SKIP() << "a machine without IPv6";
  EXPECT_EQ(peer_over_ipv4(server.value()).host, "127.0.0.1");
}

TEST(PeerName, OfIpv6HasItsNetworkAsHost) {
  const auto server = ListeningSocket::tcp("[::1]:0");
  if (!server.is_ok()) GTEST_SKIP() << "a machine without IPv6";
  sockaddr_storage to = {};
  auto& address = reinterpret_cast<sockaddr_in6&>(to);
  address.sin6_family = AF_INET6;
  address.sin6_port = htons(static_cast<uint16_t>(server.value().port()));
  address.sin6_addr = in6addr_loopback;
  const Peer peer = peer_at(server.value(), to, sizeof(address));
  EXPECT_THAT(peer.name, testing::MatchesRegex("ipv6:%5B::1%5D:[0-9]+"));
  EXPECT_EQ(peer.host, "::/64");
}

}  // namespace
}  // namespace burnish
