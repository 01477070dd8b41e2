#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "common/pages/page_file.h"
#include "server/memory/quota.h"

namespace burnish {

/// An open page file with its share of the server's memory.
struct ScanPages {
  std::string scan_id;
  PageFile file;
  Quota::Share memory;  ///< for the directory; pages stay on the disk
};

/// The page files that clients used last. A caller holds a file for as long as it needs it.
/// Thread-safe.
class OpenPages {
 public:
  /// Limit of files that stay open without a holder.
  static constexpr size_t kFilesMax = 16;

  /// Returns null if the file is not open.
  std::shared_ptr<const ScanPages> find(const std::string& scan_id);
  void add(std::shared_ptr<const ScanPages> pages);
  void forget(const std::string& scan_id);

 private:
  std::mutex mutex_;
  std::list<std::shared_ptr<const ScanPages>> open_;  // few; the last used first
};

}  // namespace burnish
