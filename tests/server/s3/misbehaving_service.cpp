#include "tests/server/s3/misbehaving_service.h"

#include <unistd.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "common/base/check.h"

namespace burnish {
namespace {

/// Reads a request; returns false if the connection ends before it.
bool read_request(int connection, MisbehavingService::Request& request) {
  std::string text;
  size_t wanted = std::string::npos;
  char piece[4096];
  while (text.size() < wanted) {
    const ssize_t bytes = ::recv(connection, piece, sizeof(piece), 0);
    if (bytes <= 0) return false;
    text.append(piece, static_cast<size_t>(bytes));
    const size_t end = text.find("\r\n\r\n");
    if (wanted != std::string::npos || end == std::string::npos) continue;
    const std::string head = text.substr(0, end + 2);
    request.line = head.substr(0, head.find("\r\n"));
    request.headers = head.substr(head.find("\r\n") + 2);
    const size_t length = head.find("Content-Length: ");
    wanted = end + 4;
    if (length != std::string::npos) wanted += std::stoul(head.substr(length + 16));
  }
  request.body = text.substr(text.find("\r\n\r\n") + 4);
  return true;
}

}  // namespace

MisbehavingService::MisbehavingService(Answer answer) : answer_(std::move(answer)) {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place = {};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  auto* address = reinterpret_cast<sockaddr*>(&place);
  socklen_t size = sizeof(place);
  const bool listens = ::bind(listener_, address, size) == 0 && ::listen(listener_, 16) == 0 &&
                       ::getsockname(listener_, address, &size) == 0;
  BURNISH_CHECK(listens, "no loopback port");
  port_ = ntohs(place.sin_port);
  acceptor_ = std::jthread([this] {
    for (int one; (one = ::accept(listener_, nullptr, nullptr)) >= 0;) {
      const std::lock_guard lock(mutex_);
      connections_.push_back(one);
      threads_.emplace_back([this, one] { serve(one); });
    }
  });
}

MisbehavingService::~MisbehavingService() {
  ::shutdown(listener_, SHUT_RDWR);
  acceptor_.join();
  for (const int one : connections_) ::shutdown(one, SHUT_RDWR);
  threads_.clear();
  for (const int one : connections_) ::close(one);
  ::close(listener_);
}

std::vector<MisbehavingService::Request> MisbehavingService::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void MisbehavingService::serve(int connection) {
  Request request;
  if (!read_request(connection, request)) return;
  {
    const std::lock_guard lock(mutex_);
    requests_.push_back(request);
  }
  const FakeAnswer answer = answer_(request);
  const size_t bytes =
      answer.body_bytes == std::string::npos ? answer.body.size() : answer.body_bytes;
  const std::string text = "HTTP/1.1 " + std::to_string(answer.status) +
                           " Answer\r\nConnection: close\r\n" + answer.more_headers +
                           "Content-Length: " + std::to_string(bytes) + "\r\n\r\n" + answer.body;
  (void)::send(connection, text.data(), text.size(), MSG_NOSIGNAL);
  char none;
  if (answer.hangs) (void)::recv(connection, &none, 1, 0);
  ::shutdown(connection, SHUT_RDWR);
}

}  // namespace burnish
