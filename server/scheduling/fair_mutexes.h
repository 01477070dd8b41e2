#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "server/scheduling/fair_mutex.h"

namespace burnish {

/// Mutexes of things that come and go, by their keys. Thread-safe.
template <typename Key>
class FairMutexes {
 public:
  /// Returns the mutex of a key: the same one for all who hold it.
  std::shared_ptr<FairMutex> of(const Key& key) {
    const std::lock_guard lock(mutex_);
    std::erase_if(mutexes_, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<FairMutex>& known = mutexes_[key];
    auto found = known.lock();
    if (!found) known = found = std::make_shared<FairMutex>();
    return found;
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<FairMutex>> mutexes_;
};

}  // namespace burnish
