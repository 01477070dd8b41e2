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

/// Views that were made, the last used ones first to stay. Whoever sends one holds it as long as he
/// needs it. Thread-safe.
class ViewCache {
 public:
  struct Key {
    std::string scan_id;
    PreparedKey prepared;
    uint64_t triangles_max;
    bool operator==(const Key&) const = default;
  };

  /// Keeps at most so many bytes; a view above that is not kept at all.
  explicit ViewCache(uint64_t bytes_max) : bytes_max_(bytes_max) {}

  std::shared_ptr<const PackedView> find(const Key& key);  ///< null where it is not kept
  void add(const Key& key, std::shared_ptr<const PackedView> view);
  uint64_t byte_count() const;

  /// Forgets views that nobody holds beside the cache, the longest unused first, until so many
  /// bytes are free or no more can be.
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
