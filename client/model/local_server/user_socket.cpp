#include "client/model/local_server/user_socket.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

#include <sys/socket.h>
#include <sys/un.h>

namespace burnish {

static Result<bool> is_of_this_user(int fd, const std::filesystem::path& socket) {
  ucred server = {};
  socklen_t length = sizeof server;
  if (getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &server, &length) != 0)
    return errno_status("cannot tell whose server listens on " + socket.string(), errno);
  if (server.uid == geteuid()) return true;
  return Status{StatusCode::kPermissionDenied,
                "the server on " + socket.string() + " belongs to user " +
                    std::to_string(server.uid) + ", not to " + std::to_string(geteuid())};
}

Result<bool> user_listens(const std::filesystem::path& socket) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (socket.native().size() > kSocketPathBytesMax)
    return invalid_argument("the socket " + socket.string() + " has a path of " +
                            std::to_string(socket.native().size()) + " bytes, the limit is " +
                            std::to_string(kSocketPathBytesMax) + " fit");
  std::memcpy(address.sun_path, socket.c_str(), socket.native().size());
  const int fd = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return errno_status("cannot make a socket", errno);
  const bool connected =
      connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int error = errno;
  Result<bool> listens = connected ? is_of_this_user(fd, socket) : Result<bool>(false);
  close(fd);
  if (connected || error == ECONNREFUSED || error == ENOENT) return listens;
  return errno_status("cannot connect to " + socket.string(), error);
}

}  // namespace burnish
