#include "server/process/input_end.h"

#include <cerrno>
#include <poll.h>
#include <unistd.h>

namespace burnish {

bool has_ended(int input) {
  char dropped[4096];
  for (;;) {
    pollfd asked = {input, POLLIN, 0};
    if (poll(&asked, 1, 0) <= 0) return false;
    const ssize_t bytes = read(input, dropped, sizeof(dropped));
    if (bytes == 0) return true;
    if (bytes < 0) return errno != EINTR && errno != EAGAIN;
  }
}

}  // namespace burnish
