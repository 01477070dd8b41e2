#include "server/rpc/connection_acceptor.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <netdb.h>
#include <poll.h>
#include <unistd.h>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include "server/metrics/metrics.h"

namespace burnish {
namespace {

std::string peer_of(int fd) {
  sockaddr_storage address = {};
  socklen_t length = sizeof(address);
  getpeername(fd, reinterpret_cast<sockaddr*>(&address), &length);
  char host[NI_MAXHOST], port[NI_MAXSERV];
  if (address.ss_family == AF_UNIX ||
      getnameinfo(reinterpret_cast<const sockaddr*>(&address), length, host, sizeof(host), port,
                  sizeof(port), NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "a local socket";
  return std::string(host) + ":" + port;
}

uint64_t socket_inode(int fd) {
  struct stat found = {};
  return fstat(fd, &found) == 0 && S_ISSOCK(found.st_mode) ? found.st_ino : 0;
}

}  // namespace

void ConnectionAcceptor::add(ListeningSocket socket, Receiver receiver) {
  doors_.push_back({std::move(socket), std::move(receiver)});
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
  for (Door& door : doors_) door.socket.close();
}

void ConnectionAcceptor::run() {
  std::vector<pollfd> waits = {{wake_, POLLIN, 0}};
  for (const Door& door : doors_) waits.push_back({door.socket.fd(), POLLIN, 0});
  for (;;) {
    if (poll(waits.data(), waits.size(), -1) < 0) continue;
    if (waits[0].revents != 0) return;
    for (size_t i = 0; i < doors_.size(); ++i)
      if (waits[i + 1].revents != 0) accept_from(doors_[i]);
  }
}

void ConnectionAcceptor::accept_from(Door& door) {
  const int fd = accept4(door.socket.fd(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (fd < 0) {
    if (errno == EAGAIN || errno == EINTR || errno == ECONNABORTED) return;
    spdlog::error("accepting on {}: {}", door.socket.address(), std::strerror(errno));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // out of descriptors or memory
    return;
  }
  std::unique_lock lock(mutex_);
  if (connections_.size() >= connections_max_) forget_closed();
  if (connections_.size() >= connections_max_) {
    spdlog::warn(
        "refused the connection of {}: {} connections are open, limits.connections_max "
        "is {}",
        peer_of(fd), connections_.size(), connections_max_);
    metrics().count_refusal(Refusal::kConnections);
    close(fd);
    return;
  }
  spdlog::debug("connection of {} to {}", peer_of(fd), door.socket.address());
  const int on = 1;
  setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
  connections_.push_back({fd, socket_inode(fd)});
  lock.unlock();
  grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters connection;
  connection.listener_fd = door.socket.fd();
  connection.fd = fd;
  door.receiver->HandleNewConnection(&connection);
}

size_t ConnectionAcceptor::open_connections() {
  const std::lock_guard lock(mutex_);
  forget_closed();
  return connections_.size();
}

void ConnectionAcceptor::forget_closed() {
  std::erase_if(connections_,
                [](const Connection& known) { return socket_inode(known.fd) != known.inode; });
}

}  // namespace burnish
