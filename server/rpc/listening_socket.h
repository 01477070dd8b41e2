#pragma once

#include <filesystem>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// Who may connect to a Unix socket.
enum class SocketAccess { kGroup, kUser };

/// A socket that waits for connections; closed with the object, and a Unix socket's name with it.
class ListeningSocket {
 public:
  /// HOST:PORT; port 0 takes a free one. Fails: unavailable when the address cannot be bound.
  static Result<ListeningSocket> tcp(const std::string& address);

  /// Takes the place of a socket that nobody listens on; its mode becomes 0660, or 0600 for the
  /// user alone. Fails: unavailable when somebody does listen there, or no socket can be made
  /// there.
  static Result<ListeningSocket> unix_domain(const std::filesystem::path& path,
                                             SocketAccess access = SocketAccess::kGroup);

  ListeningSocket(ListeningSocket&& other) noexcept;
  ~ListeningSocket();

  int fd() const { return fd_; }
  int port() const { return port_; }                       ///< 0: a Unix socket
  const std::string& address() const { return address_; }  ///< HOST:PORT, or unix:PATH

  /// Waits in vain no longer: connects fail from now on.
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
