#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace burnish {

struct LinkOptions {
  double megabits_per_second = 50;          ///< each direction, for all connections together
  std::chrono::microseconds delay{20'000};  ///< one direction: half of the round trip
};

/// A slow network in this process. It takes connections on a loopback port and passes bytes to
/// `target` (HOST:PORT of this machine, or the path of a Unix socket) and back, with limited speed
/// and a delay. As in a router, waiting bytes are bounded, so a full link slows its senders.
class Link {
 public:
  Link(const std::string& target, const LinkOptions& options);
  ~Link();

  /// Returns the address to connect to instead.
  const std::string& address() const { return address_; }

  /// Stalls or resumes the link. While it is stalled, no bytes pass and no end sees an error, as on
  /// a dead radio.
  void stall(bool stalled);

  /// Returns the bytes that have come from `target`.
  uint64_t bytes_down() const;

 private:
  class Traffic;
  std::string address_;
  std::unique_ptr<Traffic> traffic_;
};

}  // namespace burnish
