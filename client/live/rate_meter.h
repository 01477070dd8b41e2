#pragma once

#include <chrono>
#include <cstdint>
#include <deque>

namespace burnish {

/// Frames and bytes of the last second.
class RateMeter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  void add(Time now, uint64_t bytes) {
    forget(now);
    frames_.push_back({now, bytes});
    bytes_ += bytes;
  }
  double frames_per_second(Time now) {
    forget(now);
    return static_cast<double>(frames_.size());
  }
  double megabits_per_second(Time now) {
    forget(now);
    return static_cast<double>(bytes_) * 8e-6;
  }

 private:
  void forget(Time now) {
    while (!frames_.empty() && frames_.front().when + std::chrono::seconds(1) <= now) {
      bytes_ -= frames_.front().bytes;
      frames_.pop_front();
    }
  }

  struct Frame {
    Time when;
    uint64_t bytes;
  };
  std::deque<Frame> frames_;
  uint64_t bytes_ = 0;
};

}  // namespace burnish
