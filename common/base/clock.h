#pragma once

#include <chrono>
#include <cstdint>
#include <functional>

namespace burnish {

/// A source of the current time. A test moves its clock forward instead of waiting.
using Clock = std::function<std::chrono::steady_clock::time_point()>;

/// Returns the milliseconds from `begin` to `end`.
inline double ms_between(std::chrono::steady_clock::time_point begin,
                         std::chrono::steady_clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Returns the milliseconds since 1970.
inline int64_t unix_ms_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

inline int64_t unix_seconds_now() {
  return unix_ms_now() / 1000;
}

}  // namespace burnish
