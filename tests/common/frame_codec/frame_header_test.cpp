#include "common/frame_codec/frame_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<uint8_t> sealed(const FrameHeader& header) {
  std::vector<uint8_t> bytes(kFrameHeaderBytes + 10, 42);
  seal_frame(header, bytes);
  return bytes;
}

FrameHeader some_header() {
  return {.content = FrameContent::kVertices,
          .step_shift = 2,
          .sequence = 12,
          .reference = 9,
          .reference_checksum = 0x1234567890abcdef,
          .layout_fingerprint = 77,
          .sent_tiles = 3,
          .body_bytes = 1000};
}

TEST(FrameHeader, ComesBackAsItWasSealed) {
  const FrameHeader header = some_header();
  const FrameHeader read = read_frame_header(sealed(header)).value();
  EXPECT_EQ(read.content, header.content);
  EXPECT_EQ(read.step_shift, header.step_shift);
  EXPECT_EQ(read.sequence, header.sequence);
  EXPECT_EQ(read.reference, header.reference);
  EXPECT_EQ(read.reference_checksum, header.reference_checksum);
  EXPECT_EQ(read.layout_fingerprint, header.layout_fingerprint);
  EXPECT_EQ(read.sent_tiles, header.sent_tiles);
  EXPECT_EQ(read.body_bytes, header.body_bytes);
}

TEST(FrameHeader, EveryFlippedBitIsNoticed) {
  const std::vector<uint8_t> bytes = sealed(some_header());
  for (size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    std::vector<uint8_t> flipped = bytes;
    flipped[bit / 8] ^= static_cast<uint8_t>(1 << (bit % 8));
    EXPECT_FALSE(read_frame_header(flipped).is_ok()) << "bit " << bit;
  }
}

TEST(FrameHeader, EveryTruncationIsNoticed) {
  const std::vector<uint8_t> bytes = sealed(some_header());
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(read_frame_header(std::span(bytes).first(size)).status().code(),
              StatusCode::kDataLoss);
}

TEST(FrameHeader, AnotherVersionIsNamed) {
  std::vector<uint8_t> bytes = sealed(some_header());
  bytes[4] = 9;
  const Status status = read_frame_header(bytes).status();
  EXPECT_EQ(status.code(), StatusCode::kUnimplemented);
  EXPECT_THAT(status.message(), AllOf(HasSubstr("version 9,"), HasSubstr("reads 1")));
}

TEST(FrameHeader, FieldsOutsideTheirLimitsAreNamed) {
  FrameHeader header = some_header();
  header.step_shift = 8;
  EXPECT_THAT(read_frame_header(sealed(header)).status().message(),
              HasSubstr("frame 12: step shift 8 is outside 0..7"));
  header = some_header();
  header.reference = 12;
  EXPECT_THAT(read_frame_header(sealed(header)).status().message(),
              HasSubstr("its reference 12 is not an earlier frame"));
  header = some_header();
  header.content = static_cast<FrameContent>(2);
  EXPECT_THAT(read_frame_header(sealed(header)).status().message(),
              HasSubstr("content 2 is outside 0..1"));
}

}  // namespace
}  // namespace burnish
