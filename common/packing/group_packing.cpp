#include "common/packing/group_packing.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace burnish {

namespace {

using Group = std::array<uint32_t, kGroupValues>;

constexpr int kWidthOfBytes = 4;  // from this width on a value takes whole bytes

int bits_of(int width) {
  return width == 0 ? 0 : 1 << (width - 1);
}

// Returns 0 if all values are zero, else the least w whose 2^(w-1) bits hold every value.
int width_of(const Group& group) {
  uint32_t any = 0;
  for (const uint32_t value : group) any |= value;
  const int bits = std::bit_width(any);
  return bits == 0 ? 0 : 1 + std::bit_width(static_cast<unsigned>(bits - 1));
}

Group load(std::span<const uint32_t> values) {
  Group group = {};
  std::copy_n(values.begin(), std::min<size_t>(values.size(), kGroupValues), group.begin());
  return group;
}

void append_bits(const Group& group, int bits, std::vector<uint8_t>& stream) {
  uint64_t word = 0;
  for (int i = 0; i < kGroupValues; ++i) word |= static_cast<uint64_t>(group[i]) << (i * bits);
  std::array<uint8_t, sizeof(word)> bytes;
  std::memcpy(bytes.data(), &word, sizeof(word));
  stream.insert(stream.end(), bytes.begin(), bytes.begin() + kGroupValues * bits / 8);
}

void append_bytes(const Group& group, int shift, std::vector<uint8_t>& stream) {
  std::array<uint8_t, kGroupValues> bytes;
  for (int i = 0; i < kGroupValues; ++i) bytes[i] = static_cast<uint8_t>(group[i] >> shift);
  stream.insert(stream.end(), bytes.begin(), bytes.end());
}

std::span<const uint8_t> take(std::span<const uint8_t>& stream, size_t bytes) {
  const auto taken = stream.first(bytes);
  stream = stream.subspan(bytes);
  return taken;
}

void read_bits(std::span<const uint8_t>& stream, int bits, Group& group) {
  uint64_t word = 0;
  const auto bytes = take(stream, static_cast<size_t>(kGroupValues) * bits / 8);
  std::memcpy(&word, bytes.data(), bytes.size());
  const uint32_t mask = (1u << bits) - 1;
  for (int i = 0; i < kGroupValues; ++i)
    group[i] = static_cast<uint32_t>(word >> (i * bits)) & mask;
}

void add_bytes(std::span<const uint8_t>& stream, int shift, Group& group) {
  const auto bytes = take(stream, kGroupValues);
  for (int i = 0; i < kGroupValues; ++i) group[i] |= static_cast<uint32_t>(bytes[i]) << shift;
}

void pack(const Group& group, int width, std::array<std::vector<uint8_t>, kGroupStreams>& streams) {
  if (width > 0 && width < kWidthOfBytes) append_bits(group, bits_of(width), streams[0]);
  if (width >= kWidthOfBytes) append_bytes(group, 0, streams[1]);
  if (width > kWidthOfBytes) append_bytes(group, 8, streams[2]);
  if (width == kGroupWidthMax) {
    append_bytes(group, 16, streams[3]);
    append_bytes(group, 24, streams[3]);
  }
}

Group unpack(int width, std::array<std::span<const uint8_t>, kGroupStreams>& streams) {
  Group group = {};
  if (width > 0 && width < kWidthOfBytes) read_bits(streams[0], bits_of(width), group);
  if (width >= kWidthOfBytes) add_bytes(streams[1], 0, group);
  if (width > kWidthOfBytes) add_bytes(streams[2], 8, group);
  if (width == kGroupWidthMax) {
    add_bytes(streams[3], 16, group);
    add_bytes(streams[3], 24, group);
  }
  return group;
}

Result<std::array<size_t, kGroupStreams>> stream_sizes(std::span<const uint8_t> widths) {
  std::array<size_t, 16> groups_of_width = {};
  for (const uint8_t pair : widths) {
    ++groups_of_width[pair & 15];
    ++groups_of_width[pair >> 4];
  }
  std::array<size_t, kGroupStreams> sizes = {};
  for (int width = 0; width < 16; ++width) {
    if (groups_of_width[width] == 0) continue;
    if (width > kGroupWidthMax)
      return data_loss("a group has width " + std::to_string(width) + ", the largest is 6");
    const auto bytes = bytes_of_group(width);
    for (int s = 0; s < kGroupStreams; ++s) sizes[s] += groups_of_width[width] * bytes[s];
  }
  return sizes;
}

}  // namespace

std::array<size_t, kGroupStreams> bytes_of_group(int width) {
  constexpr size_t kPlane = kGroupValues;
  return {width < kWidthOfBytes ? kPlane * bits_of(width) / 8 : 0,
          width >= kWidthOfBytes ? kPlane : 0, width > kWidthOfBytes ? kPlane : 0,
          width == kGroupWidthMax ? 2 * kPlane : 0};
}

void GroupPacker::add_axis(std::span<const uint32_t> values) {
  const int groups = group_count(static_cast<int>(values.size()));
  for (int g = 0; g < groups; ++g) {
    const Group group = load(values.subspan(static_cast<size_t>(g) * kGroupValues));
    const int width = width_of(group);
    if (g % 2 == 0)
      widths.push_back(static_cast<uint8_t>(width));
    else
      widths.back() |= static_cast<uint8_t>(width << 4);
    pack(group, width, streams);
  }
}

size_t GroupPacker::byte_count() const {
  size_t count = widths.size();
  for (const auto& stream : streams) count += stream.size();
  return count;
}

void GroupPacker::append_to(std::vector<uint8_t>& bytes) const {
  bytes.insert(bytes.end(), widths.begin(), widths.end());
  for (const auto& stream : streams) bytes.insert(bytes.end(), stream.begin(), stream.end());
}

Result<GroupUnpacker> GroupUnpacker::open(size_t width_bytes, std::span<const uint8_t> bytes) {
  GroupUnpacker groups;
  ASSIGN_OR_RETURN(groups.widths, take_stream(bytes, width_bytes));
  ASSIGN_OR_RETURN(const auto sizes, stream_sizes(groups.widths));
  for (int s = 0; s < kGroupStreams; ++s) {
    ASSIGN_OR_RETURN(groups.streams[s], take_stream(bytes, sizes[s]));
  }
  if (!bytes.empty())
    return data_loss(std::to_string(bytes.size()) + " bytes follow the last stream");
  return groups;
}

void GroupUnpacker::read_axis(std::span<uint32_t> values) {
  const auto axis_widths = take(widths, width_bytes(static_cast<int>(values.size())));
  for (size_t begin = 0, g = 0; begin < values.size(); begin += kGroupValues, ++g) {
    const int width = axis_widths[g / 2] >> (4 * (g % 2)) & 15;
    const Group group = unpack(width, streams);
    std::copy_n(group.begin(), std::min<size_t>(kGroupValues, values.size() - begin),
                values.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

Result<std::span<const uint8_t>> take_stream(std::span<const uint8_t>& bytes, size_t count) {
  if (count > bytes.size())
    return data_loss("a stream has " + std::to_string(count) + " bytes, but only " +
                     std::to_string(bytes.size()) + " are left");
  return take(bytes, count);
}

}  // namespace burnish
