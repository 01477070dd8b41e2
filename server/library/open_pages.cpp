#include "server/library/open_pages.h"

#include <algorithm>

namespace burnish {

std::shared_ptr<const ScanPages> OpenPages::find(const std::string& scan_id) {
  const std::lock_guard lock(mutex_);
  const auto at =
      std::ranges::find_if(open_, [&](const auto& pages) { return pages->scan_id == scan_id; });
  if (at == open_.end()) return nullptr;
  open_.splice(open_.begin(), open_, at);
  return *at;
}

void OpenPages::add(std::shared_ptr<const ScanPages> pages) {
  const std::lock_guard lock(mutex_);
  open_.push_front(std::move(pages));
  if (open_.size() > kFilesMax) open_.pop_back();
}

void OpenPages::forget(const std::string& scan_id) {
  const std::lock_guard lock(mutex_);
  open_.remove_if([&](const auto& pages) { return pages->scan_id == scan_id; });
}

}  // namespace burnish
