#pragma once

#include <atomic>
#include <chrono>

#include "common/base/clock.h"

namespace burnish {

/// A steady clock that can be put forward, from any thread. Time also passes by itself, as code
/// expects that waits for a deadline.
class FastClock {
 public:
  std::chrono::steady_clock::time_point now() const {
    return std::chrono::steady_clock::now() + std::chrono::nanoseconds(ahead_ns_);
  }
  void put_forward(std::chrono::nanoseconds by) { ahead_ns_ += by.count(); }

  /// Needs: it is not called after this is gone.
  Clock clock() const {
    return [this] { return now(); };
  }

 private:
  std::atomic<int64_t> ahead_ns_{0};
};

}  // namespace burnish
