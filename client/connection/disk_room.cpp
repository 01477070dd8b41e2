#include "client/connection/disk_room.h"

#include <algorithm>
#include <functional>
#include <system_error>

namespace burnish {

namespace fs = std::filesystem;

static uint64_t file_bytes(const fs::path& path) {
  std::error_code error;
  const auto bytes = fs::file_size(path, error);
  return error ? 0 : bytes;
}

static fs::path with_extension(fs::path files, const char* extension) {
  return files += extension;
}

DiskRoom::DiskRoom(const fs::path& own, uint64_t bytes_max) : bytes_max_(bytes_max) {
  std::error_code error;
  for (fs::directory_iterator at(own.parent_path(), error), end; !error && at != end;
       at.increment(error)) {
    if (at->path().extension() != kIndexExtension) continue;
    const fs::path files = fs::path(at->path()).replace_extension();
    const uint64_t bytes =
        file_bytes(at->path()) + file_bytes(with_extension(files, kPagesExtension));
    bytes_ += bytes;
    std::error_code gone;
    const auto used = fs::last_write_time(at->path(), gone);
    if (files != own && !gone) others_.push_back({files, used, bytes});
  }
  std::ranges::sort(others_, std::greater<>(), &Scan::used);
}

bool DiskRoom::take(uint64_t bytes) {
  while (bytes_ + bytes > bytes_max_ && !others_.empty()) remove_oldest();
  if (bytes_ + bytes > bytes_max_) return false;
  bytes_ += bytes;
  return true;
}

// A program that has the files open keeps them until it closes them.
void DiskRoom::remove_oldest() {
  const Scan oldest = others_.back();
  others_.pop_back();
  std::error_code ignored;
  fs::remove(with_extension(oldest.files, kIndexExtension), ignored);
  fs::remove(with_extension(oldest.files, kPagesExtension), ignored);
  bytes_ -= std::min(bytes_, oldest.bytes);
}

}  // namespace burnish
