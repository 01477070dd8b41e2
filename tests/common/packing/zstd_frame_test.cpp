#include "common/packing/zstd_frame.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/packing/zigzag.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<uint8_t> rising_bytes(size_t size) {
  std::vector<uint8_t> bytes(size);
  std::iota(bytes.begin(), bytes.end(), uint8_t{0});
  return bytes;
}

TEST(ZstdFrame, SectionsComeBackOneBehindTheOther) {
  const std::vector<uint8_t> first = rising_bytes(300);
  const std::vector<uint8_t> second(5000, 7);
  const std::vector<std::span<const uint8_t>> sections = {first, {}, second};
  std::vector<uint8_t> frame = {99};
  append_compressed(sections, 1, frame);
  std::vector<uint8_t> both = first;
  both.resize(first.size() + second.size(), 7);
  EXPECT_EQ(frame[0], 99);
  EXPECT_EQ(decompress(std::span(frame).subspan(1), both.size()).value(), both);
}

TEST(ZstdFrame, NoSectionsAreAnEmptyFrame) {
  std::vector<uint8_t> frame;
  append_compressed(std::vector<std::span<const uint8_t>>(), 1, frame);
  EXPECT_TRUE(decompress(frame, 0).value().empty());
}

TEST(ZstdFrame, AnotherSizeThanExpectedIsDataLoss) {
  std::vector<uint8_t> frame;
  append_compressed(rising_bytes(100), 1, frame);
  const Status status = decompress(frame, 101).status();
  EXPECT_EQ(status.code(), StatusCode::kDataLoss);
  EXPECT_THAT(status.message(), HasSubstr("101"));
}

TEST(ZstdFrame, BytesBehindTheFrameAreDataLoss) {
  std::vector<uint8_t> frame;
  append_compressed(rising_bytes(100), 1, frame);
  frame.resize(frame.size() + 1);
  EXPECT_EQ(decompress(frame, 100).status().code(), StatusCode::kDataLoss);
}

TEST(ZstdFrame, TheFirstFrameSaysItsBytes) {
  std::vector<uint8_t> bytes;
  append_compressed(std::vector<uint8_t>(1000, 7), 1, bytes);
  const size_t size = bytes.size();
  EXPECT_EQ(compressed_bytes(bytes).value(), size);
  bytes.resize(size + 9, 3);
  EXPECT_EQ(compressed_bytes(bytes).value(), size);
  EXPECT_EQ(compressed_bytes(std::span(bytes).first(size - 1)).status().code(),
            StatusCode::kDataLoss);
  EXPECT_EQ(compressed_bytes({}).status().code(), StatusCode::kDataLoss);
}

TEST(Zigzag, SmallDifferencesOfBothSignsBecomeSmall) {
  EXPECT_EQ(to_zigzag<uint32_t>(0), 0u);
  EXPECT_EQ(to_zigzag<uint32_t>(-1u), 1u);
  EXPECT_EQ(to_zigzag<uint32_t>(1), 2u);
  EXPECT_EQ(to_zigzag<uint16_t>(uint16_t{0xfffe}), 3u);
}

TEST(Zigzag, EveryByteComesBack) {
  for (int value = 0; value < 256; ++value)
    EXPECT_EQ(from_zigzag(to_zigzag(static_cast<uint8_t>(value))), value);
}

}  // namespace
}  // namespace burnish
