#include "server/process/minute_limiter.h"

#include <utility>

namespace burnish {

MinuteLimiter::Turn MinuteLimiter::take(const std::string& what, Time now) {
  const std::lock_guard lock(mutex_);
  const auto [last, is_first] = last_.try_emplace(what, Last{now});
  if (is_first) return {true, 0};
  if (now - last->second.at < std::chrono::minutes(1)) {
    ++last->second.left_out;
    return {};
  }
  last->second.at = now;
  return {true, std::exchange(last->second.left_out, 0)};
}

}  // namespace burnish
