#pragma once

#include <mutex>
#include <string>
#include <string_view>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/scheduling/fair_mutex.h"

namespace burnish {

/// Waits in line for a mutex that others may hold for seconds. Meanwhile it asks `progress` whether
/// to go on. Fails: cancelled.
inline Result<std::unique_lock<FairMutex>> lock_or_cancel(FairMutex& mutex, std::string_view phase,
                                                          const Progress& progress) {
  std::unique_lock lock(mutex, std::try_to_lock);
  if (lock.owns_lock()) return lock;
  const auto go_on = [&] { return report(progress, phase, 0); };
  if (!go_on() || !mutex.lock_while(go_on))
    return cancelled("cancelled while " + std::string(phase));
  return std::unique_lock(mutex, std::adopt_lock);
}

}  // namespace burnish
