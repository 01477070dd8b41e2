#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace burnish {

/// Lines of the log that somebody outside can cause as fast as they like.
enum class LineKind { kRefusedCall, kEndedCall, kConnection, kTransport };

/// Admits a number of lines of each kind to the log each second, and counts the rest. Thread-safe.
class LineLimiter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit LineLimiter(uint64_t lines_per_second) : lines_per_second_(lines_per_second) {}

  /// Returns whether a line may be written now.
  bool admit(LineKind kind, Time now);

  /// Returns e.g. "1234 more lines of refused calls" for each kind that lost lines in a past
  /// second. Reports each line once.
  std::vector<std::string> take_left_out(Time now);

 private:
  struct Second {
    Time begin = {};
    uint64_t lines = 0;
    uint64_t left_out = 0;
    uint64_t left_out_before = 0;  // in past seconds, not reported yet
  };
  static void begin_if_over(Second& second, Time now);

  static constexpr size_t kKinds = 4;

  const uint64_t lines_per_second_;
  std::mutex mutex_;
  std::array<Second, kKinds> seconds_;
};

/// Returns whether the process's log takes a line of this kind now.
bool may_log(LineKind kind);

/// Logs the number of left out lines. Call it a few times a second.
void log_left_out_lines();

}  // namespace burnish
