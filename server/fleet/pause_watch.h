#pragma once

#include <atomic>
#include <chrono>
#include <functional>

namespace burnish {

/// Notices that the whole process stood still: it was stopped, or its machine slept. Another server
/// may have its sessions since. Thread-safe.
class PauseWatch {
 public:
  using Nanoseconds = std::chrono::nanoseconds;
  using BootClock = std::function<Nanoseconds()>;

  /// Returns the time since the machine's start, with the time for which it slept.
  static Nanoseconds since_boot();

  /// `pause_max`: more is a pause. Somebody must ask more often.
  explicit PauseWatch(Nanoseconds pause_max, BootClock clock = since_boot)
      : pause_max_(pause_max), clock_(std::move(clock)), last_(clock_()) {}

  /// Returns whether nobody has asked for longer than `pause_max`. Says so once for each pause.
  bool was_paused() {
    const Nanoseconds now = clock_();
    return now - last_.exchange(now) > pause_max_;
  }

 private:
  const Nanoseconds pause_max_;
  const BootClock clock_;
  std::atomic<Nanoseconds> last_;
};

}  // namespace burnish
