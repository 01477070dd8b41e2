#include "common/packing/group_packing.h"

#include <random>

#include <gtest/gtest.h>

namespace burnish {
namespace {

std::vector<uint32_t> packed_and_unpacked(const std::vector<uint32_t>& values) {
  GroupPacker packer;
  packer.add_axis(values);
  GroupUnpacker unpacker{packer.widths, {}};
  for (int s = 0; s < kGroupStreams; ++s) unpacker.streams[s] = packer.streams[s];
  std::vector<uint32_t> read(values.size(), 77);
  unpacker.read_axis(read);
  EXPECT_TRUE(unpacker.widths.empty());
  for (const auto& stream : unpacker.streams) EXPECT_TRUE(stream.empty());
  return read;
}

TEST(GroupPacking, EveryWidthComesBack) {
  for (int bits = 0; bits <= 32; ++bits) {
    const uint32_t largest = bits == 0 ? 0 : ~uint32_t{0} >> (32 - bits);
    std::vector<uint32_t> values(32, largest);
    for (uint32_t i = 0; i < 16; ++i) values[i] = largest / (i + 1);
    EXPECT_EQ(packed_and_unpacked(values), values) << bits << " bits";
  }
}

TEST(GroupPacking, EveryLengthComesBack) {
  std::mt19937 random(3);
  for (int length = 1; length <= 70; ++length) {
    std::vector<uint32_t> values(length);
    for (uint32_t& value : values) value = random() >> (random() % 32);
    EXPECT_EQ(packed_and_unpacked(values), values) << length << " values";
  }
}

TEST(GroupPacking, StreamsAreAsLongAsTheWidthsSay) {
  const std::array<uint32_t, kGroupWidthMax + 1> largest = {0, 1, 3, 15, 255, 65535, 65536};
  for (int width = 0; width <= kGroupWidthMax; ++width) {
    GroupPacker packer;
    packer.add_axis(std::vector<uint32_t>(kGroupValues, largest[width]));
    EXPECT_EQ(packer.widths, std::vector<uint8_t>{static_cast<uint8_t>(width)});
    for (int s = 0; s < kGroupStreams; ++s)
      EXPECT_EQ(packer.streams[s].size(), bytes_of_group(width)[s]) << width;
  }
}

TEST(GroupPacking, ZerosTakeHalfAByteAGroup) {
  GroupPacker packer;
  packer.add_axis(std::vector<uint32_t>(2048, 0));
  EXPECT_EQ(packer.widths.size(), 64u);
  for (const auto& stream : packer.streams) EXPECT_TRUE(stream.empty());
}

}  // namespace
}  // namespace burnish
