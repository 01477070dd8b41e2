#pragma once

#include <chrono>

namespace burnish {

/// Says when a server has been unused for so long that it may end.
class IdleEnd {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `idle_max` 0: never.
  IdleEnd(std::chrono::seconds idle_max, Time now) : idle_max_(idle_max), last_use_(now) {}

  /// Returns true if nobody has used it for `idle_max`. Call it all the time.
  bool is_over(bool in_use, Time now) {
    if (in_use) last_use_ = now;
    return idle_max_.count() > 0 && now - last_use_ >= idle_max_;
  }

 private:
  std::chrono::seconds idle_max_;
  Time last_use_;
};

}  // namespace burnish
