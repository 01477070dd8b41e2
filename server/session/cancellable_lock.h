#pragma once

#include <chrono>
#include <mutex>
#include <string_view>

#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

/// Waits for a mutex that others may hold for seconds, and asks `progress` meanwhile whether the
/// caller still wants it. Fails: cancelled.
template <typename Mutex>
Result<std::unique_lock<Mutex>> lock_or_cancel(Mutex& mutex, std::string_view phase,
                                               const Progress& progress) {
  std::unique_lock lock(mutex, std::try_to_lock);
  while (!lock.owns_lock()) {
    if (!report(progress, phase, 0)) return cancelled("cancelled while " + std::string(phase));
    if (lock.try_lock_for(std::chrono::milliseconds(100))) break;
  }
  return lock;
}

}  // namespace burnish
