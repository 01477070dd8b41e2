#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace burnish {

/// What a test's service does with a request.
struct FakeAnswer {
  int status = 200;
  std::string body = {};
  size_t body_bytes = std::string::npos;  ///< announced; npos: those that it has
  bool hangs = false;                     ///< after the body; the connection stays
  std::string more_headers = {};          ///< lines, each with its end
};

/// A service of HTTP that does what a test wants: fails, breaks off, hangs. It checks nothing.
class MisbehavingService {
 public:
  struct Request {
    std::string line;     ///< "GET /bucket/key HTTP/1.1"
    std::string headers;  ///< the lines after it
    std::string body;
  };
  using Answer = std::function<FakeAnswer(const Request&)>;

  explicit MisbehavingService(Answer answer);
  ~MisbehavingService();

  std::string endpoint() const { return "http://127.0.0.1:" + std::to_string(port_); }
  /// Returns the requests so far.
  std::vector<Request> requests() const;

 private:
  void serve(int connection);

  const Answer answer_;
  int listener_;
  uint16_t port_;
  mutable std::mutex mutex_;
  std::vector<Request> requests_;
  std::vector<int> connections_;
  std::vector<std::jthread> threads_;
  std::jthread acceptor_;
};

}  // namespace burnish
