#include "tests/server/metrics/http_get.h"

#include <cstdlib>
#include <unistd.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace burnish {

std::string http_get_metrics(int port) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<uint16_t>(port));
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  std::string answer;
  if (connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) {
    const std::string request = "GET /metrics HTTP/1.0\r\n\r\n";
    (void)!write(fd, request.data(), request.size());
    char piece[4096];
    for (ssize_t size; (size = read(fd, piece, sizeof(piece))) > 0;)
      answer.append(piece, static_cast<size_t>(size));
  }
  close(fd);
  return answer;
}

double metric(const std::string& text, const std::string& name) {
  const size_t line = text.find("\n" + name + " ");
  return line == std::string::npos ? -1 : std::atof(text.c_str() + line + name.size() + 2);
}

}  // namespace burnish
