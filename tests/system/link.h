#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace burnish {

struct LinkOptions {
  double megabits_per_second = 50;          ///< each way, for all connections together
  std::chrono::microseconds delay{20'000};  ///< one way: half of the round trip
};

/// A slow network in this process: takes connections on a loopback port, passes their bytes on to
/// `target` (HOST:PORT, IPv4) and back, no faster than told and so much later. What waits is
/// bounded, as in a router, so that a full link holds up its senders.
class Link {
 public:
  Link(const std::string& target, const LinkOptions& options);
  ~Link();

  /// What to connect to instead.
  const std::string& address() const { return address_; }

  /// While it is stalled nothing comes through and nobody is told: as behind a dead radio.
  void stall(bool stalled);

  /// That have come from `target`.
  uint64_t bytes_down() const;

 private:
  class Traffic;
  std::string address_;
  std::unique_ptr<Traffic> traffic_;
};

}  // namespace burnish
