#include "server/session/fair_mutex.h"

#include <utility>

namespace burnish {

void FairMutex::lock() {
  (void)lock_until(std::chrono::steady_clock::time_point::max());
}

bool FairMutex::try_lock() {
  const std::lock_guard lock(mutex_);
  if (held_) return false;
  return held_ = true;
}

bool FairMutex::lock_until(std::chrono::steady_clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  if (!held_) return held_ = true;
  const auto mine = waiters_.emplace(waiters_.end());
  const auto is_mine = [&] { return mine->is_owner; };
  // Waiting until the end of time would overflow the system's clock.
  const bool got = deadline == std::chrono::steady_clock::time_point::max()
                       ? (mine->wake.wait(lock, is_mine), true)
                       : mine->wake.wait_until(lock, deadline, is_mine);
  waiters_.erase(mine);
  return got;
}

void FairMutex::unlock() {
  std::unique_lock lock(mutex_);
  // A waiter that was given the mutex has not taken itself off the list yet, but then it holds it.
  if (!waiters_.empty()) {
    waiters_.front().is_owner = true;
    waiters_.front().wake.notify_one();
    return;
  }
  held_ = false;
  const std::function<void()> tell = std::exchange(tell_, nullptr);
  lock.unlock();
  if (tell) tell();
}

void FairMutex::when_free(std::function<void()> tell) {
  {
    const std::lock_guard lock(mutex_);
    if (held_) {
      tell_ = std::move(tell);
      return;
    }
  }
  tell();
}

}  // namespace burnish
