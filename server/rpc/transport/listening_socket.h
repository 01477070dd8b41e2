#pragma once

#include <filesystem>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Says who may connect to a Unix socket.
enum class SocketAccess { kGroup, kUser };

/// A socket that waits for connections. It is closed with the object, and a Unix socket's name is
/// removed.
class ListeningSocket {
 public:
  /// HOST:PORT; port 0 takes a free port. Fails: unavailable if the address cannot be bound.
  static Result<ListeningSocket> tcp(const std::string& address);

  /// Takes the place of a socket that nobody listens on. Its mode becomes 0660, or 0600 for the
  /// user alone. Fails: unavailable if somebody listens there, or no socket can be made there.
  static Result<ListeningSocket> unix_domain(const std::filesystem::path& path,
                                             SocketAccess access = SocketAccess::kGroup);

  ListeningSocket(ListeningSocket&& other) noexcept;
  ~ListeningSocket();

  int fd() const { return fd_; }
  int port() const { return port_; }                       ///< 0 for a Unix socket
  const std::string& address() const { return address_; }  ///< HOST:PORT, or unix:PATH

  /// Stops waiting: connects fail from now on.
  void close();

 private:
  ListeningSocket(int fd, int port, std::string address, std::filesystem::path path)
      : fd_(fd), port_(port), address_(std::move(address)), path_(std::move(path)) {}

  int fd_;
  int port_;
  std::string address_;
  std::filesystem::path path_;
};

}  // namespace burnish
