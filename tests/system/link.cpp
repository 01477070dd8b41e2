#include "tests/system/link.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <fcntl.h>
#include <list>
#include <poll.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <arpa/inet.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <sys/un.h>

#include "common/base/check.h"

namespace burnish {
namespace {

using Time = std::chrono::steady_clock::time_point;

constexpr size_t kPieceBytes = 1500;  // a packet

sockaddr_in loopback(int port) {
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<uint16_t>(port));
  return address;
}

struct Target {
  union {
    sockaddr any;
    sockaddr_in port;
    sockaddr_un path;
  } address = {};
  socklen_t size = sizeof(sockaddr_in);
};

Target target_of(const std::string& text) {
  Target target;
  if (text.front() != '/') {
    target.address.port = loopback(std::stoi(text.substr(text.rfind(':') + 1)));
    return target;
  }
  target.address.path.sun_family = AF_UNIX;
  target.size = sizeof(sockaddr_un);
  BURNISH_CHECK(text.size() < sizeof(target.address.path.sun_path), text);
  text.copy(target.address.path.sun_path, text.size());
  return target;
}

void prepare(int socket) {
  const int yes = 1, bytes = 1 << 16;
  fcntl(socket, F_SETFL, O_NONBLOCK);
  setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof(yes));
  setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &bytes, sizeof(bytes));
}

/// One direction of all connections. Says when a piece that comes now is through.
class Way {
 public:
  explicit Way(const LinkOptions& options)
      : options_(options),
        waiting_max_(static_cast<size_t>(options.megabits_per_second * 1e6 / 8 *
                                         std::chrono::duration<double>(options.delay).count()) +
                     (1 << 16)) {}

  Time through(Time now, size_t bytes) {
    const std::chrono::duration<double> takes(static_cast<double>(bytes) * 8e-6 /
                                              options_.megabits_per_second);
    free_ = std::max(free_, now) + std::chrono::duration_cast<std::chrono::nanoseconds>(takes);
    return free_ + options_.delay;
  }
  /// Returns the limit of waiting bytes: the bytes of one delay, and a few more.
  size_t waiting_max() const { return waiting_max_; }

 private:
  const LinkOptions options_;
  const size_t waiting_max_;
  Time free_ = {};
};

/// The bytes of one connection in one direction.
struct Pipe {
  struct Piece {
    Time due;
    std::vector<char> bytes;
    size_t sent = 0;
  };

  int from = -1, to = -1;
  std::deque<Piece> pieces;
  size_t waiting = 0;
  bool ended = false;  // no more bytes come

  bool has_room(const Way& way) const { return !ended && waiting < way.waiting_max(); }
  bool is_due(Time now) const { return !pieces.empty() && pieces.front().due <= now; }

  /// Takes bytes that have come. Returns their number.
  size_t take(Way& way, Time now) {
    std::vector<char> bytes(kPieceBytes);
    const size_t before = waiting;
    while (has_room(way)) {
      const ssize_t count = recv(from, bytes.data(), bytes.size(), 0);
      if (count == 0) ended = true;
      if (count <= 0) break;
      const auto size = static_cast<size_t>(count);
      pieces.push_back({way.through(now, size), {bytes.begin(), bytes.begin() + count}});
      waiting += size;
    }
    return waiting - before;
  }

  bool give(Time now) {
    while (is_due(now)) {
      Piece& piece = pieces.front();
      const ssize_t count =
          send(to, piece.bytes.data() + piece.sent, piece.bytes.size() - piece.sent, MSG_NOSIGNAL);
      if (count < 0) return errno == EAGAIN;
      piece.sent += static_cast<size_t>(count);
      waiting -= static_cast<size_t>(count);
      if (piece.sent == piece.bytes.size()) pieces.pop_front();
    }
    return true;
  }
};

struct Ends {
  Pipe up, down;
  bool broken = false;
};

}  // namespace

class Link::Traffic {
 public:
  Traffic(int listener, const Target& target, const LinkOptions& options)
      : listener_(listener), target_(target), up_(options), down_(options) {
    thread_ = std::thread([this] {
      while (!stopping_) pass_on();
    });
  }

  ~Traffic() {
    stopping_ = true;
    thread_.join();
    for (Ends& ends : connections_) close_both(ends);
    close(listener_);
  }

  void stall(bool stalled) { stalled_ = stalled; }
  uint64_t bytes_down() const { return bytes_down_; }

 private:
  void pass_on() {
    if (stalled_) return std::this_thread::sleep_for(std::chrono::milliseconds(10));
    wait();
    accept_new();
    for (Ends& ends : connections_) {
      ends.up.take(up_, std::chrono::steady_clock::now());
      bytes_down_ += ends.down.take(down_, std::chrono::steady_clock::now());
      const Time now = std::chrono::steady_clock::now();
      ends.broken = !ends.up.give(now) || !ends.down.give(now) ||
                    (ends.up.ended && ends.up.pieces.empty()) ||
                    (ends.down.ended && ends.down.pieces.empty());
      if (ends.broken) close_both(ends);
    }
    connections_.remove_if([](const Ends& ends) { return ends.broken; });
  }

  // Waits until a socket is ready, or a piece is through.
  void wait() {
    const Time now = std::chrono::steady_clock::now();
    Time next = now + std::chrono::milliseconds(50);
    std::vector<pollfd> polled = {{listener_, POLLIN, 0}};
    const auto watch = [&](const Pipe& pipe, const Way& way) {
      if (pipe.has_room(way)) polled.push_back({pipe.from, POLLIN, 0});
      if (pipe.is_due(now)) polled.push_back({pipe.to, POLLOUT, 0});
      if (!pipe.pieces.empty() && !pipe.is_due(now)) next = std::min(next, pipe.pieces.front().due);
    };
    for (const Ends& ends : connections_) {
      watch(ends.up, up_);
      watch(ends.down, down_);
    }
    const auto left = std::chrono::duration_cast<std::chrono::nanoseconds>(next - now).count();
    const timespec patience = {0, static_cast<long>(std::clamp<int64_t>(left, 0, 50'000'000))};
    ppoll(polled.data(), polled.size(), &patience, nullptr);
  }

  void accept_new() {
    const int client = accept(listener_, nullptr, nullptr);
    if (client < 0) return;
    const int server = socket(target_.address.any.sa_family, SOCK_STREAM, 0);
    if (connect(server, &target_.address.any, target_.size) != 0) {
      close(server);
      close(client);
      return;
    }
    prepare(client);
    prepare(server);
    Ends ends;
    ends.up.from = ends.down.to = client;
    ends.up.to = ends.down.from = server;
    connections_.push_back(std::move(ends));
  }

  static void close_both(const Ends& ends) {
    close(ends.up.from);
    close(ends.up.to);
  }

  const int listener_;
  const Target target_;
  Way up_, down_;
  std::list<Ends> connections_;
  std::atomic<bool> stopping_{false};
  std::atomic<bool> stalled_{false};
  std::atomic<uint64_t> bytes_down_{0};
  std::thread thread_;
};

Link::Link(const std::string& target, const LinkOptions& options) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof(address);
  BURNISH_CHECK(bind(listener, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                    listen(listener, 64) == 0 &&
                    getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size) == 0,
                "a link has a port of its own");
  address_ = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  traffic_ = std::make_unique<Traffic>(listener, target_of(target), options);
}

Link::~Link() = default;

uint64_t Link::bytes_down() const {
  return traffic_->bytes_down();
}

void Link::stall(bool stalled) {
  traffic_->stall(stalled);
}

}  // namespace burnish
