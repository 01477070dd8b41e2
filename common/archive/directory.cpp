#include "common/archive/directory.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace burnish {

namespace {

constexpr uint32_t kEndMark = 0x06054b50, kEnd64Mark = 0x06064b50, kLocator64Mark = 0x07064b50;
constexpr uint32_t kRecordMark = 0x02014b50, kHeaderMark = 0x04034b50;
constexpr uint64_t kEndBytes = 22, kEnd64Bytes = 56, kLocator64Bytes = 20;
constexpr uint64_t kRecordBytes = 46, kHeaderBytes = 30;
constexpr uint32_t kIn64 = UINT32_MAX;  // the value stands in the ZIP64 field
constexpr uint16_t kCountIn64 = UINT16_MAX;
constexpr uint16_t kEncrypted = 1, kSizesFollow = 8;

Status damaged(const std::string& what) {
  return invalid_argument("the archive is damaged: " + what);
}

/// Numbers in bytes, the lowest byte first.
class LittleEndian {
 public:
  explicit LittleEndian(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  uint64_t size() const { return bytes_.size(); }
  /// Returns whether `count` bytes lie at a place.
  bool has(uint64_t at, uint64_t count) const {
    return at <= bytes_.size() && count <= bytes_.size() - at;
  }

  /// Return 0, or an empty text, where the bytes end.
  uint16_t half(uint64_t at) const { return static_cast<uint16_t>(number(at, 2)); }
  uint32_t word(uint64_t at) const { return static_cast<uint32_t>(number(at, 4)); }
  uint64_t twice(uint64_t at) const { return number(at, 8); }
  std::string_view text(uint64_t at, uint64_t count) const {
    if (!has(at, count)) return {};
    return {reinterpret_cast<const char*>(bytes_.data()) + at, count};
  }

 private:
  uint64_t number(uint64_t at, uint64_t count) const {
    if (!has(at, count)) return 0;
    uint64_t value = 0;
    for (uint64_t i = count; i-- > 0;) value = value << 8 | bytes_[at + i];
    return value;
  }

  std::span<const uint8_t> bytes_;
};

/// The place of the directory.
struct DirectoryPlace {
  uint64_t begin = 0;
  uint64_t bytes = 0;
  uint64_t entries = 0;
};

/// Returns the end record whose comment reaches to the end of the file.
std::optional<uint64_t> find_end(const LittleEndian& file) {
  for (uint64_t at = file.size() - kEndBytes;; --at) {
    if (file.word(at) == kEndMark && at + kEndBytes + file.half(at + 20) == file.size()) return at;
    if (at == 0 || file.size() - at > kEndBytes + UINT16_MAX) return std::nullopt;
  }
}

Result<DirectoryPlace> find_directory64(const LittleEndian& file, uint64_t end) {
  const uint64_t locator = end - kLocator64Bytes;
  if (end < kLocator64Bytes || file.word(locator) != kLocator64Mark)
    return damaged("its ZIP64 end record is missing");
  const uint64_t end64 = file.twice(locator + 8);
  if (!file.has(end64, kEnd64Bytes) || file.word(end64) != kEnd64Mark)
    return damaged("its ZIP64 end record is missing");
  return DirectoryPlace{file.twice(end64 + 48), file.twice(end64 + 40), file.twice(end64 + 32)};
}

Result<DirectoryPlace> find_directory(const LittleEndian& file) {
  const auto end = file.size() < kEndBytes ? std::nullopt : find_end(file);
  if (!end)
    return invalid_argument("the archive is damaged, or it is not a ZIP archive: it has no end");
  DirectoryPlace place{file.word(*end + 16), file.word(*end + 12), file.half(*end + 10)};
  if (place.begin == kIn64 || place.bytes == kIn64 || place.entries == kCountIn64) {
    ASSIGN_OR_RETURN(place, find_directory64(file, *end));
  }
  if (!file.has(place.begin, place.bytes) || place.begin + place.bytes > *end)
    return damaged("its directory is cut off");
  return place;
}

/// Takes the values that stand in the ZIP64 field of `fields` instead. Returns false if one is
/// missing.
bool take_values64(const LittleEndian& file, uint64_t fields, uint64_t fields_bytes,
                   std::initializer_list<uint64_t*> values) {
  if (std::ranges::none_of(values, [](const uint64_t* value) { return *value == kIn64; }))
    return true;
  constexpr uint16_t kField64 = 1;
  const uint64_t end = fields + fields_bytes;
  for (uint64_t at = fields; at + 4 <= end; at += 4 + file.half(at + 2)) {
    if (file.half(at) != kField64) continue;
    const uint64_t field_end = at + 4 + file.half(at + 2);
    at += 4;
    for (uint64_t* value : values) {
      if (*value != kIn64) continue;
      if (at + 8 > std::min(field_end, end)) return false;
      *value = file.twice(at);
      at += 8;
    }
    return true;
  }
  return false;
}

/// Returns whether a header's additional fields are whole. Padding of up to three zeros may follow
/// them. libzip does not copy an entry whose fields are not.
bool are_whole(const LittleEndian& file, uint64_t fields, uint64_t fields_bytes) {
  const uint64_t end = fields + fields_bytes;
  uint64_t at = fields;
  while (at + 4 <= end) at += 4 + file.half(at + 2);
  if (at > end) return false;
  return std::ranges::all_of(file.text(at, end - at), [](char c) { return c == 0; });
}

Result<DirectoryRecord> read_record(const LittleEndian& file, uint64_t& at, uint64_t end) {
  if (at + kRecordBytes > end || file.word(at) != kRecordMark)
    return damaged("its directory is cut off");
  const uint64_t name = file.half(at + 28), fields = file.half(at + 30);
  const uint64_t bytes = kRecordBytes + name + fields + file.half(at + 32);
  if (bytes > end - at) return damaged("its directory is cut off");
  DirectoryRecord record{file.text(at + kRecordBytes, name), file.half(at + 8), file.half(at + 10),
                         file.word(at + 16)};
  record.packed_bytes = file.word(at + 20);
  record.bytes = file.word(at + 24);
  record.header = file.word(at + 42);
  if (!take_values64(file, at + kRecordBytes + name, fields,
                     {&record.bytes, &record.packed_bytes, &record.header}))
    return damaged("a size of ZIP64 is missing in its directory");
  at += bytes;
  return record;
}

}  // namespace

Result<std::vector<DirectoryRecord>> read_directory(std::span<const uint8_t> archive) {
  const LittleEndian file(archive);
  ASSIGN_OR_RETURN(const DirectoryPlace place, find_directory(file));
  std::vector<DirectoryRecord> records;
  uint64_t at = place.begin;
  for (uint64_t e = 0; e < place.entries; ++e) {
    ASSIGN_OR_RETURN(const DirectoryRecord record,
                     read_record(file, at, place.begin + place.bytes));
    records.push_back(record);
  }
  return records;
}

Status check_header(std::span<const uint8_t> archive, const DirectoryRecord& record) {
  const LittleEndian file(archive);
  const uint64_t at = record.header;
  if (!file.has(at, kHeaderBytes) || file.word(at) != kHeaderMark)
    return damaged("the entry's own header is missing");
  const uint64_t name = file.half(at + 26), fields = file.half(at + 28);
  const uint64_t content = at + kHeaderBytes + name + fields;
  if (!file.has(content, record.packed_bytes)) return damaged("the entry is cut off");
  if (!are_whole(file, at + kHeaderBytes + name, fields))
    return damaged("a field of the entry's own header is cut off");
  const uint16_t flags = file.half(at + 6);
  if (file.text(at + kHeaderBytes, name) != record.name)
    return damaged("the entry has another name in its own header");
  if (file.half(at + 8) != record.method || ((flags ^ record.flags) & kEncrypted) != 0)
    return damaged("the entry is packed in another way by its own header");
  uint64_t packed = file.word(at + 18), bytes = file.word(at + 22);
  const bool may_follow = (flags & kSizesFollow) != 0;
  const bool is_whole =
      take_values64(file, at + kHeaderBytes + name, fields, {&bytes, &packed}) || may_follow;
  const auto fits = [&](uint64_t value, uint64_t in_directory) {
    return value == in_directory || (may_follow && (value == 0 || value == kIn64));
  };
  if (!is_whole || !fits(packed, record.packed_bytes) || !fits(bytes, record.bytes))
    return damaged("the entry has another size in its own header");
  if (!fits(file.word(at + 14), record.crc))
    return damaged("the entry has another sum in its own header");
  return Status::ok();
}

}  // namespace burnish
