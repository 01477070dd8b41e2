#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>

namespace burnish {

/// A mutex that is handed on in the order in which it was asked for: whoever works at something
/// turn by turn, all the time, keeps nobody out. Whoever must not wait can ask to be told when it
/// is worth another try. Works with std::unique_lock.
class FairMutex {
 public:
  void lock();
  bool try_lock();
  void unlock();

  template <typename Rep, typename Period>
  bool try_lock_for(const std::chrono::duration<Rep, Period>& time) {
    return lock_until(std::chrono::steady_clock::now() + time);
  }

  /// Calls `tell` once, soon: from unlock(), or now when nobody holds the mutex. It must be short
  /// and must not touch the mutex. A new call replaces one that has not been told.
  void when_free(std::function<void()> tell);

 private:
  struct Waiter {
    std::condition_variable wake;
    bool is_owner = false;
  };

  bool lock_until(std::chrono::steady_clock::time_point deadline);

  std::mutex mutex_;  // of what follows
  bool held_ = false;
  std::list<Waiter> waiters_;  // the first one waits longest
  std::function<void()> tell_;
};

}  // namespace burnish
