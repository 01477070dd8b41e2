#pragma once

#include <cstddef>
#include <mutex>
#include <set>
#include <string>

namespace burnish {

/// Scans of which something is known. An id names the bytes of a scan, so it stays true.
/// Thread-safe.
class KnownScans {
 public:
  /// Beyond so many any one is forgotten.
  static constexpr size_t kScansMax = 1000;

  bool has(const std::string& scan_id) const {
    const std::lock_guard lock(mutex_);
    return ids_.contains(scan_id);
  }

  void add(const std::string& scan_id) {
    const std::lock_guard lock(mutex_);
    if (ids_.size() >= kScansMax) ids_.erase(ids_.begin());
    ids_.insert(scan_id);
  }

 private:
  mutable std::mutex mutex_;
  std::set<std::string> ids_;
};

}  // namespace burnish
