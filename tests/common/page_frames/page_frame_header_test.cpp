#include "common/page_frames/page_frame_header.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

class PageFrameHeaderTest : public testing::Test {
 protected:
  Status status_of(const PageFrameHeader& header) {
    seal_page_frame(header, frame_);
    return read_page_frame_header(frame_).status();
  }

  PageFrameHeader header_ = {.kind = PageFrameKind::kCorners,
                             .step_shift = 3,
                             .sequence = 8,
                             .reference = 5,
                             .reference_checksum = 0x123456789abcdef0,
                             .revision = 4,
                             .largest_move = 2.5F,
                             .sent_pages = 6,
                             .body_bytes = 77};
  std::vector<uint8_t> frame_ = std::vector<uint8_t>(kPageFrameHeaderBytes + 10, 9);
};

TEST_F(PageFrameHeaderTest, ComesBack) {
  const uint64_t checksum = seal_page_frame(header_, frame_);
  const auto read = read_page_frame_header(frame_);
  ASSERT_TRUE(read.is_ok()) << read.status().message();
  EXPECT_EQ(read->kind, header_.kind);
  EXPECT_EQ(read->step_shift, 3);
  EXPECT_EQ(read->sequence, 8u);
  EXPECT_EQ(read->reference, 5u);
  EXPECT_EQ(read->reference_checksum, header_.reference_checksum);
  EXPECT_EQ(read->revision, 4u);
  EXPECT_EQ(read->largest_move, 2.5F);
  EXPECT_EQ(read->sent_pages, 6u);
  EXPECT_EQ(read->body_bytes, 77u);
  EXPECT_EQ(read->checksum, checksum);
  EXPECT_FALSE(read->is_key());
}

TEST_F(PageFrameHeaderTest, EveryByteIsUnderTheChecksumOrIsNamed) {
  seal_page_frame(header_, frame_);
  for (size_t at = 0; at < frame_.size(); ++at) {
    std::vector<uint8_t> changed = frame_;
    changed[at] ^= 16;
    const StatusCode code = read_page_frame_header(changed).status().code();
    EXPECT_EQ(code, at == 4 ? StatusCode::kUnimplemented : StatusCode::kDataLoss) << at;
  }
}

TEST_F(PageFrameHeaderTest, AShortFrameIsRefused) {
  seal_page_frame(header_, frame_);
  EXPECT_THAT(read_page_frame_header(std::span(frame_).first(55)).status().message(),
              HasSubstr("has 55 bytes, its header needs 56"));
}

TEST_F(PageFrameHeaderTest, VersionOneIsNamed) {
  seal_page_frame(header_, frame_);
  frame_[4] = 1;
  EXPECT_THAT(read_page_frame_header(frame_).status().message(),
              HasSubstr("version 1, this program reads 2"));
}

TEST_F(PageFrameHeaderTest, FieldsOutsideTheirLimitsAreRefused) {
  header_.kind = static_cast<PageFrameKind>(2);
  EXPECT_THAT(status_of(header_).message(), HasSubstr("kind 2 is outside 0..1"));
  header_.kind = PageFrameKind::kVertices;
  header_.step_shift = 8;
  EXPECT_THAT(status_of(header_).message(), HasSubstr("step shift 8 is outside 0..7"));
  header_.step_shift = 0;
  header_.reference = 8;
  EXPECT_THAT(status_of(header_).message(), HasSubstr("reference 8 is not an earlier frame"));
}

TEST_F(PageFrameHeaderTest, AMoveThatIsNotALengthIsRefused) {
  for (const float move :
       {-1.F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    header_.largest_move = move;
    EXPECT_THAT(status_of(header_).message(), HasSubstr("cells is not a length"));
  }
}

}  // namespace
}  // namespace burnish
