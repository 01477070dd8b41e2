#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/packing/zstd_frame.h"
#include "common/page_frames/page_frame_body.h"
#include "common/page_frames/page_frame_decoder.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Key frames whose bodies an encoder would not write, sealed as if they were good.
class HostilePageFrame : public testing::Test {
 protected:
  HostilePageFrame() {
    EXPECT_TRUE(decoder_.show(change_, 100).is_ok());
    header_ = {.sequence = 1, .revision = 1, .sent_pages = 1};
    body_ = {1, 0, 0};
    body_.resize(3 + size_t{3} * width_bytes(40), 0);
  }

  Status decode_status(const std::vector<uint8_t>& body) {
    header_.body_bytes = static_cast<uint32_t>(body.size());
    return decode_with_header(body);
  }
  Status decode_with_header(const std::vector<uint8_t>& body) {
    std::vector<uint8_t> frame(kPageFrameHeaderBytes);
    append_compressed(body, 1, frame);
    seal_page_frame(header_, frame);
    return decoder_.decode(frame).status();
  }

  const PageChange change_ = {1, {plain_page(7, 40), plain_page(8, 300), plain_page(9, 2048)}, {}};
  PageFrameDecoder decoder_{PageFrameKind::kVertices};
  PageFrameHeader header_;
  std::vector<uint8_t> body_;  // a correct body of zeros
};

TEST_F(HostilePageFrame, TheBodyBeforeItIsSpoiltIsGood) {
  const Status status = decode_status(body_);
  EXPECT_TRUE(status.is_ok()) << status.message();
}

TEST_F(HostilePageFrame, AnEmptyBodyIsRefused) {
  EXPECT_EQ(decode_status({}).code(), StatusCode::kDataLoss);
}

TEST_F(HostilePageFrame, AMarkAboveSevenIsRefused) {
  body_[1] = 8;
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("marked 8, the largest mark is 7"));
}

TEST_F(HostilePageFrame, AHeldVertexBeyondThePagesLastIsRefused) {
  body_[1] |= 4;
  body_.insert(body_.begin() + 3, held_bytes(300), 0xff);
  EXPECT_THAT(decode_status(body_).message(),
              HasSubstr("page 8 holds a vertex beyond its last, 299"));
  body_[3 + held_bytes(300) - 1] = 0x0f;
  EXPECT_TRUE(decode_status(body_).is_ok());
}

TEST_F(HostilePageFrame, AWrongCountOfPagesIsRefused) {
  header_.sent_pages = 2;
  EXPECT_THAT(decode_status(body_).message(),
              HasSubstr("1 pages are marked as sent, the header says 2"));
}

TEST_F(HostilePageFrame, AMissingGainIsRefused) {
  EXPECT_THAT(decode_status({1, 0, 2}).message(), HasSubstr("frame 1"));
}

TEST_F(HostilePageFrame, AGainAboveItsLimitIsRefused) {
  body_[2] = 2;
  body_.insert(body_.begin() + 3, 16);
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("gain 2^16, the largest is 2^15"));
}

TEST_F(HostilePageFrame, AWidthAboveSixIsRefused) {
  body_[3] = 0x70;
  EXPECT_THAT(decode_status(body_).message(),
              HasSubstr("frame 1: a group has width 7, the largest is 6"));
}

TEST_F(HostilePageFrame, StreamsShorterThanTheirWidthsAreRefused) {
  body_[3] = 0x04;
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("16 bytes, but only 0 are left"));
}

TEST_F(HostilePageFrame, BytesBehindTheLastStreamAreRefused) {
  body_.push_back(0);
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("1 bytes follow the last stream"));
}

TEST_F(HostilePageFrame, ABodyLargerThanThePagesAllowIsRefusedBeforeItIsUnpacked) {
  header_.body_bytes =
      static_cast<uint32_t>(page_body_bytes_max(decoder_.newest_shown().pages())) + 1;
  EXPECT_THAT(decode_with_header(body_).message(), HasSubstr("bytes, the limit is"));
}

TEST_F(HostilePageFrame, ARevisionThatNobodyAskedForIsRefused) {
  header_.revision = 2;
  const Status status = decode_status(body_);
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("revision 2 is outside 0..1"));
}

TEST_F(HostilePageFrame, ARevisionThatIsOverIsRefused) {
  ASSERT_TRUE(decode_status(body_).is_ok());
  header_.sequence = 2;
  header_.revision = 0;
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("revision 0 is outside 1..1"));
}

TEST_F(HostilePageFrame, AnotherKindIsRefused) {
  header_.kind = PageFrameKind::kCorners;
  EXPECT_EQ(decode_status(body_).code(), StatusCode::kInvalidArgument);
}

TEST_F(HostilePageFrame, LargestResidualsEverywhereWrapAround) {
  PageFrameBodyWriter writer(change_.added.size());
  for (size_t place = 0; place < change_.added.size(); ++place)
    writer.add_values(place,
                      std::vector<uint32_t>(size_t{3} * change_.added[place].value_count(), ~0u));
  header_.sent_pages = writer.sent_pages();
  header_.step_shift = kPageStepShiftMax;
  EXPECT_TRUE(decode_status(writer.bytes()).is_ok());
}

TEST_F(HostilePageFrame, ARefusedFrameChangesNothing) {
  ASSERT_TRUE(decode_status(body_).is_ok());
  const auto before = values_of(decoder_.state());
  header_.sequence = 2;
  body_.push_back(0);
  EXPECT_FALSE(decode_status(body_).is_ok());
  EXPECT_EQ(values_of(decoder_.state()), before);
  body_.pop_back();
  EXPECT_TRUE(decode_status(body_).is_ok());
}

}  // namespace
}  // namespace burnish
