#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "client/connection/disk_room.h"
#include "client/pages/page_item.h"
#include "common/base/status.h"

namespace burnish {

/// Limit of all fetched pages in a folder, by default.
inline constexpr uint64_t kPageDiskBytesMax = 1'000'000'000;

/// Keeps the fetched pages and blocks of one scan in a folder, from one run of the program to the
/// next. One process at a time uses the pages of a scan; for the others they are missing. Nothing
/// that goes wrong is more than a missing item. Thread-safe.
///
/// Each scan has two files, named by its fingerprint. NAME.pages has the encoded items, one after
/// the other. NAME.index has a record for each: where it is, and a checksum of the record. Both
/// only grow.
class PageDisk {
 public:
  /// An empty folder: all items are missing, and none is kept. Makes the folder for this user
  /// alone. Does not use a folder that belongs to another user, or into which others can write.
  PageDisk(const std::filesystem::path& folder, uint64_t pages_fingerprint,
           uint64_t bytes_max = kPageDiskBytesMax);
  ~PageDisk();
  PageDisk(const PageDisk&) = delete;
  PageDisk& operator=(const PageDisk&) = delete;

  /// Fails: not_found; data_loss for a damaged item, which is forgotten.
  Result<std::vector<uint8_t>> find(PageItem item);
  /// Keeps nothing that is damaged, that is there already, or for which there is no room. Keeps no
  /// items of sheets.
  void keep(PageItem item, std::span<const uint8_t> bytes);

 private:
  struct Place {
    uint64_t offset = 0;
    uint32_t bytes = 0;
  };

  bool open(const std::filesystem::path& files);
  void read_index();
  void close();

  std::mutex mutex_;  // of all
  int index_ = -1;    // file descriptors; -1: nothing is kept
  int pages_ = -1;
  uint64_t index_end_ = 0;
  uint64_t pages_end_ = 0;
  std::map<PageItem, Place> places_;
  std::optional<DiskRoom> room_;
};

}  // namespace burnish
