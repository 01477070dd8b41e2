#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "common/base/file_budget.h"
#include "common/base/status.h"
#include "common/mesh/ply/ply_header.h"

namespace burnish {

static_assert(std::endian::native == std::endian::little);

/// Reads the values of a binary PLY body, one after the other. A double holds every PLY type
/// exactly.
template <bool kBigEndian>
class PlyBinarySource {
 public:
  PlyBinarySource(std::span<const uint8_t> bytes, const PlyHeader& header, const std::string& name,
                  const FileSteps& steps = {})
      : bytes_(bytes), position_(header.body_offset), steps_(steps), name_(name) {}

  /// Returns false if the body ends inside the value; failure() then says so.
  bool read(PlyType type, double& value) {
    switch (type) {
      case PlyType::kInt8:
        return read_as<int8_t>(value);
      case PlyType::kUint8:
        return read_as<uint8_t>(value);
      case PlyType::kInt16:
        return read_as<int16_t>(value);
      case PlyType::kUint16:
        return read_as<uint16_t>(value);
      case PlyType::kInt32:
        return read_as<int32_t>(value);
      case PlyType::kUint32:
        return read_as<uint32_t>(value);
      case PlyType::kFloat32:
        return read_as<float>(value);
      case PlyType::kFloat64:
        return read_as<double>(value);
    }
    return false;
  }

  /// Skips several values in the same way.
  bool skip(PlyType type, uint64_t count) {
    if (count > values_left_max(type)) return false;
    position_ += count * bytes_of(type);
    return true;
  }

  /// Returns how many values can follow at most.
  uint64_t values_left_max(PlyType type) const {
    return (bytes_.size() - position_) / bytes_of(type);
  }

  /// Returns true: an element may end anywhere.
  bool at_line_end() { return true; }

  /// Returns whether the last value has more digits than a float holds: never, the type decides.
  bool last_exceeds_float(double) const { return false; }

  /// Returns the bytes of the last value, inside the file's. Needs: the value was read, not
  /// skipped.
  std::string_view last_bytes() const {
    return {reinterpret_cast<const char*>(bytes_.data() + position_ - last_size_), last_size_};
  }

  /// Says why read() returned false.
  std::string failure() const { return "the file ends inside it"; }

  Status error(const std::string& what) const {
    return invalid_argument(name_ + ": byte " + std::to_string(position_) + ": " + what);
  }

 private:
  template <typename T>
  bool read_as(double& value) {
    if (bytes_.size() - position_ < sizeof(T)) return false;
    steps_.take();
    std::array<uint8_t, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes_.data() + position_, sizeof(T));
    if constexpr (kBigEndian) std::reverse(raw.begin(), raw.end());
    value = static_cast<double>(std::bit_cast<T>(raw));
    position_ += sizeof(T);
    last_size_ = sizeof(T);
    return true;
  }

  std::span<const uint8_t> bytes_;
  size_t position_;
  size_t last_size_ = 0;
  FileSteps steps_;
  const std::string& name_;
};

}  // namespace burnish
