#include "server/session/view_cache.h"

#include <algorithm>

namespace burnish {

std::shared_ptr<const PackedView> ViewCache::find(const Key& key) {
  const std::lock_guard lock(mutex_);
  const auto it = std::ranges::find(kept_, key, &Kept::key);
  if (it == kept_.end()) return nullptr;
  kept_.splice(kept_.begin(), kept_, it);
  return it->view;
}

void ViewCache::add(const Key& key, std::shared_ptr<const PackedView> view) {
  const std::lock_guard lock(mutex_);
  const uint64_t bytes = view->bytes.size();
  if (bytes > bytes_max_) return;
  while (bytes_ + bytes > bytes_max_) {
    bytes_ -= kept_.back().view->bytes.size();
    kept_.pop_back();
  }
  kept_.push_front({key, std::move(view)});
  bytes_ += bytes;
}

uint64_t ViewCache::byte_count() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace burnish
