#pragma once

#include <map>
#include <mutex>
#include <utility>

namespace burnish {

/// Counts who wishes the same thing, so that who makes it knows whether it is still wished once
/// its own caller has gone. Thread-safe.
template <typename Key>
class SharedWishes {
 public:
  /// Counts while it lives. Needs: its SharedWishes outlives it.
  class Wish {
   public:
    Wish(SharedWishes& wishes, Key key) : wishes_(wishes), key_(std::move(key)) {
      const std::lock_guard lock(wishes_.mutex_);
      ++wishes_.counts_[key_];
    }
    ~Wish() {
      const std::lock_guard lock(wishes_.mutex_);
      const auto count = wishes_.counts_.find(key_);
      if (--count->second == 0) wishes_.counts_.erase(count);
    }
    Wish(const Wish&) = delete;
    Wish& operator=(const Wish&) = delete;

    /// Returns whether somebody else wishes the same now.
    bool is_shared() const {
      const std::lock_guard lock(wishes_.mutex_);
      return wishes_.counts_.at(key_) > 1;
    }

   private:
    SharedWishes& wishes_;
    const Key key_;
  };

 private:
  std::mutex mutex_;
  std::map<Key, int> counts_;
};

}  // namespace burnish
