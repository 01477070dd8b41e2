#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>
#include <zlib.h>

namespace burnish {

/// How a program writes the header before an entry whose sum and sizes follow it.
enum class LocalSizes { kAll, kNone, kUnpackedAlone };

/// An archive as other programs write it, byte by byte. Entries are stored.
class ZipText {
 public:
  LocalSizes sizes = LocalSizes::kAll;
  uint8_t system = 3;  ///< of the entries: 3 is Unix, 0 is Windows
  bool is_zip64 = false;

  void add(const std::string& name, const std::string& content) {
    const bool follows = sizes != LocalSizes::kAll;
    const auto sum = static_cast<uint32_t>(::crc32(
        0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
    const auto length = static_cast<uint32_t>(content.size());
    const std::string common = half(20) + half(follows ? 8 : 0) + half(0) + half(0) + half(0x21);
    const auto header = static_cast<uint32_t>(bytes_.size());
    bytes_ += "PK\3\4" + common + word(follows ? 0 : sum) + word(follows ? 0 : length) +
              word(sizes == LocalSizes::kNone ? 0 : length) + half(name.size()) + half(0) + name +
              content;
    if (follows) bytes_ += "PK\7\10" + word(sum) + word(length) + word(length);
    const std::string fields = is_zip64 ? half(1) + half(8) + twice(header) : "";
    directory_ += std::string("PK\1\2") + "\x14" + static_cast<char>(system) + common + word(sum) +
                  word(length) + word(length) + half(name.size()) + half(fields.size()) + half(0) +
                  half(0) + half(0) + word(0) + word(is_zip64 ? UINT32_MAX : header) + name +
                  fields;
    ++entries_;
  }

  std::vector<uint8_t> bytes() const {
    std::string all = bytes_ + directory_;
    if (is_zip64)
      all += "PK\6\6" + twice(44) + half(45) + half(45) + word(0) + word(0) + twice(entries_) +
             twice(entries_) + twice(directory_.size()) + twice(bytes_.size()) + "PK\6\7" +
             word(0) + twice(bytes_.size() + directory_.size()) + word(1);
    const uint64_t count = is_zip64 ? UINT16_MAX : entries_;
    all += "PK\5\6" + word(0) + half(count) + half(count) + word(directory_.size()) +
           word(is_zip64 ? UINT32_MAX : bytes_.size()) + half(0);
    return {all.begin(), all.end()};
  }

 private:
  static std::string number(uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
    return text;
  }
  static std::string half(uint64_t value) { return number(value, 2); }
  static std::string word(uint64_t value) { return number(value, 4); }
  static std::string twice(uint64_t value) { return number(value, 8); }

  std::string bytes_, directory_;
  uint64_t entries_ = 0;
};

}  // namespace burnish
