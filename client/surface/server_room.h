#pragma once

#include <chrono>
#include <cstdint>

namespace burnish {

/// How many vertices the server lets a client show: any number until it refuses. Then half of what
/// it refused, and slowly more. Each refusal doubles the time between two steps.
class ServerRoom {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kFirstPause{10};
  static constexpr std::chrono::seconds kPauseMax{320};
  static constexpr uint64_t kVerticesMin = 4096;  ///< it never asks for less

  /// The server had no memory for so many vertices.
  void refuse(uint64_t vertices, Time now);

  /// Returns the most vertices to show; 0: any number.
  uint64_t vertices_max(Time now);

 private:
  uint64_t max_ = 0;
  uint64_t refused_ = 0;
  std::chrono::seconds pause_ = kFirstPause / 2;
  Time rises_at_;
};

}  // namespace burnish
