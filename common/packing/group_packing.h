#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/base/status.h"

namespace burnish {

inline constexpr int kGroupValues = 16;
inline constexpr int kGroupWidthMax = 6;

/// The streams that hold the groups: packed, byte 0, byte 1, byte 2. Widths have their own stream.
/// A frame's header describes them.
inline constexpr int kGroupStreams = 4;

inline int group_count(int values) {
  return (values + kGroupValues - 1) / kGroupValues;
}
/// Returns the bytes of an axis in the stream of widths.
inline int width_bytes(int values) {
  return (group_count(values) + 1) / 2;
}

/// Returns the bytes that a group of this width takes in each stream.
std::array<size_t, kGroupStreams> bytes_of_group(int width);

/// Returns the largest number of bytes that an axis takes in all streams, widths included.
inline size_t axis_bytes_max(int values) {
  return width_bytes(values) + size_t{kGroupValues} * sizeof(uint32_t) * group_count(values);
}

/// Packs axes one after the other.
struct GroupPacker {
  std::vector<uint8_t> widths;
  std::array<std::vector<uint8_t>, kGroupStreams> streams;

  void add_axis(std::span<const uint32_t> values);

  size_t byte_count() const;
  /// Appends the widths, then the streams in order.
  void append_to(std::vector<uint8_t>& bytes) const;
};

/// Unpacks them again, in the same order. Keeps spans of the bytes.
/// Needs: each stream has the length that the widths say; no width is above kGroupWidthMax.
struct GroupUnpacker {
  std::span<const uint8_t> widths;
  std::array<std::span<const uint8_t>, kGroupStreams> streams;

  /// Opens what append_to() wrote. Fails: data_loss if a width is too large, or if the bytes are
  /// not as many as the widths say.
  static Result<GroupUnpacker> open(size_t width_bytes, std::span<const uint8_t> bytes);

  void read_axis(std::span<uint32_t> values);
};

/// Takes the first `count` bytes off. Fails: data_loss if there are fewer.
Result<std::span<const uint8_t>> take_stream(std::span<const uint8_t>& bytes, size_t count);

}  // namespace burnish
