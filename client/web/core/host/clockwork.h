#pragma once

#include <chrono>

namespace burnish {

/// Does something at times of its own. core_tick() asks all that exist.
class Clockwork {
 public:
  using Time = std::chrono::steady_clock::time_point;

  Clockwork();
  virtual ~Clockwork();
  Clockwork(const Clockwork&) = delete;
  Clockwork& operator=(const Clockwork&) = delete;

  /// Returns when to be asked again at the latest.
  virtual Time on_time(Time now) = 0;

  /// Asks all. Returns the first time of all.
  static Time ask_all(Time now);
};

}  // namespace burnish
