#include "server/rpc/transport/listening_socket.h"

#include <cerrno>
#include <cstring>
#include <memory>
#include <netdb.h>
#include <unistd.h>
#include <utility>

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace burnish {
namespace {

constexpr int kBacklog = 128;
constexpr int kSocketFlags = SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK;

Status cannot_listen(const std::string& address, const std::string& why) {
  return unavailable("cannot listen on " + address + ": " + why);
}

struct FreeAddresses {
  void operator()(addrinfo* list) const { freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

Result<Addresses> resolve(const std::string& address) {
  const size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE;
  addrinfo* list = nullptr;
  const int code = getaddrinfo(host.c_str(), address.c_str() + colon + 1, &hints, &list);
  if (code != 0) return cannot_listen(address, gai_strerror(code));
  return Addresses(list);
}

/// Returns a socket bound to the first address that works; else -1 and errno.
int bind_first(const addrinfo* list) {
  for (; list; list = list->ai_next) {
    const int fd = socket(list->ai_family, kSocketFlags, 0);
    if (fd < 0) continue;
    const int on = 1;
    setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));  // in spite of old connections' ends
    if (bind(fd, list->ai_addr, list->ai_addrlen) == 0 && listen(fd, kBacklog) == 0) return fd;
    const int error = errno;
    ::close(fd);
    errno = error;
  }
  return -1;
}

int port_of(int fd) {
  sockaddr_storage address = {};
  socklen_t length = sizeof(address);
  getsockname(fd, reinterpret_cast<sockaddr*>(&address), &length);
  return ntohs(address.ss_family == AF_INET6 ? reinterpret_cast<sockaddr_in6&>(address).sin6_port
                                             : reinterpret_cast<sockaddr_in&>(address).sin_port);
}

/// Removes a socket that a former server has left. Fails if a server listens there.
Status remove_stale(const std::filesystem::path& path, const sockaddr_un& address) {
  struct stat found = {};
  if (lstat(path.c_str(), &found) != 0) return Status::ok();
  if (!S_ISSOCK(found.st_mode))
    return cannot_listen("unix:" + path.string(), "the file there is not a socket");
  const int fd = socket(AF_UNIX, kSocketFlags, 0);
  const int error =
      connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0 ? 0 : errno;
  ::close(fd);
  if (error == 0 || error == EAGAIN)
    return cannot_listen("unix:" + path.string(), "another server already listens there");
  if (error != ECONNREFUSED)  // cannot find out whether it is in use
    return cannot_listen(
        "unix:" + path.string(),
        std::string("cannot tell whether the socket is in use: ") + std::strerror(error));
  unlink(path.c_str());
  return Status::ok();
}

}  // namespace

Result<ListeningSocket> ListeningSocket::tcp(const std::string& address) {
  ASSIGN_OR_RETURN(const Addresses list, resolve(address));
  const int fd = bind_first(list.get());
  if (fd < 0) return cannot_listen(address, std::strerror(errno));
  const int port = port_of(fd);
  return ListeningSocket(fd, port, address.substr(0, address.rfind(':') + 1) + std::to_string(port),
                         {});
}

Result<ListeningSocket> ListeningSocket::unix_domain(const std::filesystem::path& path,
                                                     SocketAccess access) {
  const std::string name = "unix:" + path.string();
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (path.native().size() >= sizeof(address.sun_path)) return cannot_listen(name, "too long");
  std::memcpy(address.sun_path, path.c_str(), path.native().size());
  RETURN_IF_ERROR(remove_stale(path, address));
  const int fd = socket(AF_UNIX, kSocketFlags, 0);
  // Nobody can connect between bind() and listen(), so the mode is right in time.
  const mode_t mode = access == SocketAccess::kUser ? 0600 : 0660;
  const bool done = bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0 &&
                    chmod(path.c_str(), mode) == 0 && listen(fd, kBacklog) == 0;
  if (done) return ListeningSocket(fd, 0, name, path);
  const std::string why = std::strerror(errno);
  ::close(fd);
  return cannot_listen(name, why);
}

ListeningSocket::ListeningSocket(ListeningSocket&& other) noexcept
    : fd_(std::exchange(other.fd_, -1)),
      port_(other.port_),
      address_(std::move(other.address_)),
      path_(std::exchange(other.path_, {})) {}

ListeningSocket::~ListeningSocket() {
  close();
}

void ListeningSocket::close() {
  if (fd_ < 0) return;
  if (!path_.empty()) unlink(path_.c_str());
  ::close(std::exchange(fd_, -1));
}

}  // namespace burnish
