#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace burnish {

inline constexpr int kGroupValues = 16;
inline constexpr int kGroupWidthMax = 6;

/// The streams of a frame's body that hold the groups (frame_header.h): packed, byte 0, byte 1,
/// byte 2. Widths have their own stream.
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

/// Packs axes one after the other.
struct GroupPacker {
  std::vector<uint8_t> widths;
  std::array<std::vector<uint8_t>, kGroupStreams> streams;

  void add_axis(std::span<const uint32_t> values);
};

/// Unpacks them again, in the same order.
/// Needs: each stream has the length that the widths say; no width is above kGroupWidthMax.
struct GroupUnpacker {
  std::span<const uint8_t> widths;
  std::array<std::span<const uint8_t>, kGroupStreams> streams;

  void read_axis(std::span<uint32_t> values);
};

}  // namespace burnish
