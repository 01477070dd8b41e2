#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "common/service/scan_info.h"
#include "common/view/view.h"

namespace burnish {

/// Views that were made; the last used ones stay longest. A sender holds its view while it needs
/// it. Thread-safe.
class ViewCache {
 public:
  struct Key {
    std::string scan_id;
    PreparedKey prepared;
    uint64_t triangles_max;
    bool operator==(const Key&) const = default;
  };

  /// Keeps at most `bytes_max`; a larger view is not kept.
  explicit ViewCache(uint64_t bytes_max) : bytes_max_(bytes_max) {}

  std::shared_ptr<const PackedView> find(const Key& key);  ///< null if not kept
  void add(const Key& key, std::shared_ptr<const PackedView> view);
  uint64_t byte_count() const;

  /// Forgets views that only the cache holds, the longest unused first, until `bytes` are free or
  /// none is left.
  void give_back(uint64_t bytes);

  /// Forgets the views of a scan.
  void forget(const std::string& scan_id);

 private:
  struct Kept {
    Key key;
    std::shared_ptr<const PackedView> view;
  };

  const uint64_t bytes_max_;
  mutable std::mutex mutex_;
  std::list<Kept> kept_;  // few; the last used first
  uint64_t bytes_ = 0;
};

}  // namespace burnish
