#include "tests/system/private_data.h"

#include <csignal>
#include <cstring>
#include <thread>
#include <unistd.h>

#include <sys/socket.h>
#include <sys/un.h>

namespace burnish {

PrivateData::PrivateData() {
  std::filesystem::permissions(folder / "", std::filesystem::perms(0755));
}

PrivateData::~PrivateData() {
  kill_server();
}

pid_t PrivateData::server() const {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::strcpy(address.sun_path, private_socket(options.data).c_str());
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ucred peer = {};
  socklen_t length = sizeof peer;
  if (connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
    getsockopt(fd, SOL_SOCKET, SO_PEERCRED, &peer, &length);
  close(fd);
  return peer.pid;
}

void PrivateData::kill_server() const {
  while (const pid_t pid = server()) {
    kill(pid, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace burnish
