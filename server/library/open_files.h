#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>

namespace burnish {

/// The files of scans that clients used last. A caller holds a file for as long as it needs it.
/// `File` has a `scan_id`. Thread-safe.
template <typename File>
class OpenFiles {
 public:
  /// Limit of files that stay open without a holder.
  static constexpr size_t kFilesMax = 16;

  /// Returns null if the file is not open. `fits`: of several files of a scan, whether it is it.
  template <typename Fits>
  std::shared_ptr<const File> find(const std::string& scan_id, const Fits& fits) {
    const std::lock_guard lock(mutex_);
    const auto at = std::ranges::find_if(
        open_, [&](const auto& file) { return file->scan_id == scan_id && fits(*file); });
    if (at == open_.end()) return nullptr;
    open_.splice(open_.begin(), open_, at);
    return *at;
  }

  void add(std::shared_ptr<const File> file) {
    const std::lock_guard lock(mutex_);
    open_.push_front(std::move(file));
    if (open_.size() > kFilesMax) open_.pop_back();
  }

  std::shared_ptr<const File> find(const std::string& scan_id) { return find(scan_id, kAny); }

  template <typename Fits>
  void forget(const std::string& scan_id, const Fits& fits) {
    const std::lock_guard lock(mutex_);
    open_.remove_if([&](const auto& file) { return file->scan_id == scan_id && fits(*file); });
  }
  void forget(const std::string& scan_id) { forget(scan_id, kAny); }

 private:
  static constexpr auto kAny = [](const File&) { return true; };

  std::mutex mutex_;
  std::list<std::shared_ptr<const File>> open_;  // few; the last used first
};

}  // namespace burnish
