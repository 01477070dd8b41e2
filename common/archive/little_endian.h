#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace burnish {

/// Private to this folder: numbers in bytes, the lowest byte first.
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

}  // namespace burnish
