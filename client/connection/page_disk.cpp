#include "client/connection/page_disk.h"

#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

#include <sys/file.h>
#include <sys/stat.h>

#include "common/packing/checksum.h"
#include "common/pages/page_format.h"

namespace burnish {

namespace fs = std::filesystem;

namespace {

/// A record of the index.
struct IndexRecord {
  uint32_t kind = 0;
  uint32_t number = 0;
  uint64_t offset = 0;
  uint32_t bytes = 0;
  uint32_t zero = 0;
  uint64_t checksum = 0;  ///< of what is before
};
static_assert(sizeof(IndexRecord) == 32);

uint64_t checksum_of(const IndexRecord& record) {
  const std::span bytes(reinterpret_cast<const uint8_t*>(&record), sizeof record);
  constexpr size_t kBefore = offsetof(IndexRecord, checksum);
  return sealed_checksum(bytes.first(kBefore), kBefore, kBefore);
}

bool is_sound(const IndexRecord& record, uint64_t pages_bytes) {
  return record.checksum == checksum_of(record) && record.kind <= 1 &&
         record.bytes <= pages_bytes && record.offset <= pages_bytes - record.bytes;
}

/// Says by the item's own checksum whether it came whole (page_format.h).
bool is_whole(PageItem item, std::span<const uint8_t> bytes) {
  const size_t header =
      item.kind == PageItem::Kind::kPage ? kPageHeaderBytes : kPageBlockHeaderBytes;
  uint64_t checksum;
  if (bytes.size() < header || bytes.size() > UINT32_MAX) return false;
  std::memcpy(&checksum, &bytes[header - sizeof checksum], sizeof checksum);
  return sealed_checksum(bytes, header - sizeof checksum, header) == checksum;
}

bool read_all(int file, std::span<uint8_t> bytes, uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t got = pread(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<size_t>(got));
    offset += static_cast<uint64_t>(got);
  }
  return true;
}

bool write_all(int file, std::span<const uint8_t> bytes, uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t put = pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    bytes = bytes.subspan(static_cast<size_t>(put));
    offset += static_cast<uint64_t>(put);
  }
  return true;
}

std::string name_of_scan(uint64_t pages_fingerprint) {
  char name[17];
  std::snprintf(name, sizeof name, "%016" PRIx64, pages_fingerprint);
  return name;
}

bool is_private_folder(const fs::path& folder) {
  std::error_code error;
  if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), error);
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST) return false;
  constexpr mode_t kOthersMayWrite = 0022;
  struct stat found = {};
  return lstat(folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) &&
         found.st_uid == geteuid() && (found.st_mode & kOthersMayWrite) == 0;
}

int open_file(fs::path files, const char* extension) {
  files += extension;
  return ::open(files.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
}

uint64_t bytes_of_file(int file) {
  struct stat found = {};
  return fstat(file, &found) == 0 ? static_cast<uint64_t>(found.st_size) : 0;
}

}  // namespace

PageDisk::PageDisk(const fs::path& folder, uint64_t pages_fingerprint, uint64_t bytes_max) {
  if (folder.empty() || !is_private_folder(folder)) return;
  const fs::path files = folder / name_of_scan(pages_fingerprint);
  if (!open(files)) {
    close();
    return;
  }
  read_index();
  room_.emplace(files, bytes_max);
}

PageDisk::~PageDisk() {
  close();
}

void PageDisk::close() {
  if (index_ >= 0) ::close(index_);
  if (pages_ >= 0) ::close(pages_);
  index_ = pages_ = -1;
}

// The time of the index says when the scan was used last.
bool PageDisk::open(const fs::path& files) {
  index_ = open_file(files, kIndexExtension);
  if (index_ < 0 || flock(index_, LOCK_EX | LOCK_NB) != 0) return false;
  pages_ = open_file(files, kPagesExtension);
  return pages_ >= 0 && futimens(index_, nullptr) == 0;
}

// New records overwrite all from the first damaged one on. A later record of an item is the better
// one: the one before was found damaged.
void PageDisk::read_index() {
  pages_end_ = bytes_of_file(pages_);
  std::vector<IndexRecord> records(bytes_of_file(index_) / sizeof(IndexRecord));
  const std::span bytes(reinterpret_cast<uint8_t*>(records.data()),
                        records.size() * sizeof(IndexRecord));
  if (!read_all(index_, bytes, 0)) return;
  for (const IndexRecord& record : records) {
    if (!is_sound(record, pages_end_)) return;
    places_[{record.number, static_cast<PageItem::Kind>(record.kind)}] = {record.offset,
                                                                          record.bytes};
    index_end_ += sizeof record;
  }
}

Result<std::vector<uint8_t>> PageDisk::find(PageItem item) {
  const std::lock_guard lock(mutex_);
  const auto found = places_.find(item);
  if (found == places_.end()) return not_found("the disk does not have it");
  std::vector<uint8_t> bytes(found->second.bytes);
  if (read_all(pages_, bytes, found->second.offset) && is_whole(item, bytes)) return bytes;
  places_.erase(found);
  return data_loss("it is damaged on the disk");
}

// The item comes before its record: a record without its item does not arise.
void PageDisk::keep(PageItem item, std::span<const uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  if (pages_ < 0 || item.is_of_sheets() || places_.contains(item) || !is_whole(item, bytes)) return;
  if (!room_->take(bytes.size() + sizeof(IndexRecord))) return;
  IndexRecord record{.kind = static_cast<uint32_t>(item.kind),
                     .number = item.number,
                     .offset = pages_end_,
                     .bytes = static_cast<uint32_t>(bytes.size())};
  record.checksum = checksum_of(record);
  const std::span raw(reinterpret_cast<const uint8_t*>(&record), sizeof record);
  if (!write_all(pages_, bytes, pages_end_) || !write_all(index_, raw, index_end_)) return close();
  places_[item] = {pages_end_, record.bytes};
  pages_end_ += bytes.size();
  index_end_ += sizeof record;
}

}  // namespace burnish
