#include "server/library/view_cache.h"

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

void ViewCache::give_back(uint64_t bytes) {
  std::list<Kept> gone;  // destroyed after the lock: a view gives back its share of a quota
  const std::lock_guard lock(mutex_);
  uint64_t freed = 0;
  for (auto it = kept_.end(); it != kept_.begin() && freed < bytes;) {
    --it;
    if (it->view.use_count() > 1) continue;
    freed += it->view->bytes.size();
    const auto dropped = it++;
    gone.splice(gone.end(), kept_, dropped);
  }
  bytes_ -= freed;
}

void ViewCache::forget(const std::string& scan_id) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const Kept& kept) {
    if (kept.key.scan_id != scan_id) return false;
    bytes_ -= kept.view->bytes.size();
    return true;
  });
}

uint64_t ViewCache::byte_count() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

}  // namespace burnish
