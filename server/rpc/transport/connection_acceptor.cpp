#include "server/rpc/transport/connection_acceptor.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <poll.h>
#include <unistd.h>
#include <utility>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include "server/metrics/metrics.h"
#include "server/process/line_limiter.h"
#include "server/rpc/transport/peer_name.h"

namespace burnish {

using std::chrono::steady_clock;

static constexpr int kSweepMs = 1000;

namespace {

uint64_t socket_inode(int fd) {
  struct stat found = {};
  return fstat(fd, &found) == 0 && S_ISSOCK(found.st_mode) ? found.st_ino : 0;
}

}  // namespace

void ConnectionAcceptor::add(ListeningSocket socket, Receiver receiver, Silence silence) {
  listeners_.push_back({std::move(socket), std::move(receiver), silence});
}

void ConnectionAcceptor::start() {
  wake_ = eventfd(0, EFD_CLOEXEC);
  thread_ = std::thread([this] { run(); });
}

void ConnectionAcceptor::stop() {
  if (!thread_.joinable()) return;
  const uint64_t one = 1;
  (void)!write(wake_, &one, sizeof(one));
  thread_.join();
  close(wake_);
  for (Listener& listener : listeners_) listener.socket.close();
}

void ConnectionAcceptor::run() {
  std::vector<pollfd> waits = {{wake_, POLLIN, 0}};
  for (const Listener& listener : listeners_) waits.push_back({listener.socket.fd(), POLLIN, 0});
  for (;;) {
    const int ready = poll(waits.data(), waits.size(), has_unknown() ? kSweepMs : -1);
    if (waits[0].revents != 0) return;
    for (size_t i = 0; ready > 0 && i < listeners_.size(); ++i)
      if (waits[i + 1].revents != 0) accept_from(listeners_[i]);
    close_silent();
  }
}

void ConnectionAcceptor::accept_from(Listener& listener) {
  const int fd = accept4(listener.socket.fd(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (fd < 0) {
    if (errno == EAGAIN || errno == EINTR || errno == ECONNABORTED) return;
    spdlog::error("cannot accept connections on {}: {}", listener.socket.address(),
                  std::strerror(errno));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // out of descriptors or memory
    return;
  }
  const Peer peer = peer_of_socket(fd);
  const std::string why = refusal(peer.host);
  if (!why.empty()) {
    if (may_log(LineKind::kConnection))
      spdlog::warn("refused the connection of {}: {}", peer.name, why);
    metrics().count_refusal(Refusal::kConnections);
    close(fd);
    return;
  }
  spdlog::debug("connection of {} to {}", peer.name, listener.socket.address());
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  {
    const std::lock_guard lock(mutex_);
    connections_[peer.name] = {
        fd, socket_inode(fd), peer.host, steady_clock::now(), peer.host.empty(), listener.silence};
  }
  listener.receiver(listener.socket.fd(), fd, peer.name);
}

size_t ConnectionAcceptor::open_connections() {
  const std::lock_guard lock(mutex_);
  forget_closed();
  return connections_.size() + leaving_.size();
}

/// Returns why a connection of this host is refused; empty: it is not.
std::string ConnectionAcceptor::refusal(const std::string& host) {
  const std::lock_guard lock(mutex_);
  const auto of_host = [&] {
    return static_cast<size_t>(std::ranges::count_if(
        connections_, [&](const auto& known) { return known.second.host == host; }));
  };
  const auto is_full = [&] { return connections_.size() >= limits_.connections_max; };
  const auto has_its_share = [&] {
    return !host.empty() && of_host() >= limits_.connections_per_peer;
  };
  if (is_full() || has_its_share()) forget_closed();
  if (is_full() && !has_its_share()) make_room();
  if (is_full())
    return std::to_string(connections_.size()) +
           " connections are open, limits.connections_max is " +
           std::to_string(limits_.connections_max);
  if (has_its_share())
    return host + " has " + std::to_string(of_host()) +
           " connections open, limits.connections_per_peer is " +
           std::to_string(limits_.connections_per_peer);
  return {};
}

/// Closes the oldest connection without an admitted call, if there is one. Not more than a share of
/// all may be on their way out: each still has a descriptor.
void ConnectionAcceptor::make_room() {
  const auto is_older = [](const auto& a, const auto& b) {
    const auto key = [](const Connection& of) { return std::pair(of.is_admitted, of.since); };
    return key(a.second) < key(b.second);
  };
  const auto oldest = std::ranges::min_element(connections_, is_older);
  if (oldest == connections_.end() || oldest->second.is_admitted ||
      leaving_.size() > limits_.connections_max / 8)
    return;
  if (may_log(LineKind::kConnection))
    spdlog::warn("closed the connection of {} for a new one: no call was admitted, and {} are open",
                 oldest->first, connections_.size());
  metrics().count_refusal(Refusal::kConnections);
  shutdown(oldest->second.fd, SHUT_RDWR);
  leaving_.push_back(oldest->second);
  connections_.erase(oldest);
}

void ConnectionAcceptor::forget_closed() {
  std::erase_if(leaving_, [](const Connection& connection) {
    return socket_inode(connection.fd) != connection.inode;
  });
  std::erase_if(connections_, [](const auto& entry) {
    const auto& [peer, connection] = entry;
    if (socket_inode(connection.fd) == connection.inode) return false;
    // The only line that names a peer refused by its headers: gRPC does not tell the peer then.
    if (connection.waits_for_call() && may_log(LineKind::kConnection))
      spdlog::info("connection of {} ended: no call was admitted", peer);
    return true;
  });
}

bool ConnectionAcceptor::has_unknown() {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(connections_,
                             [](const auto& known) { return known.second.waits_for_call(); });
}

void ConnectionAcceptor::note_call(const std::string& peer) {
  const std::lock_guard lock(mutex_);
  const auto found = connections_.find(peer);
  if (found != connections_.end()) found->second.is_admitted = true;
}

void ConnectionAcceptor::close_silent() {
  const auto now = steady_clock::now();
  if (now - last_sweep_ < std::chrono::milliseconds(kSweepMs)) return;
  last_sweep_ = now;
  const std::lock_guard lock(mutex_);
  forget_closed();
  for (auto& [peer, connection] : connections_) {
    if (!connection.waits_for_call() || now - connection.since < limits_.silence_max) continue;
    if (may_log(LineKind::kConnection))
      spdlog::warn("closed the connection of {}: no call was admitted within {} s", peer,
                   limits_.silence_max.count());
    metrics().count_refusal(Refusal::kConnections);
    // The receiver owns the descriptor and closes it when it reads the end. If the number belongs
    // to another socket by now, that is one of the metrics, whose client will ask again.
    shutdown(connection.fd, SHUT_RDWR);
    connection.is_admitted = true;
  }
}

}  // namespace burnish
