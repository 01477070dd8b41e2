#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/frame_codec/frame_body.h"
#include "common/packing/zstd_frame.h"
#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// Key frames whose bodies an encoder would not write, sealed as if they were good.
class HostileFrame : public testing::Test {
 protected:
  HostileFrame() {
    header_.content = layout_->content;
    header_.sequence = 1;
    header_.layout_fingerprint = layout_->fingerprint;
    header_.sent_tiles = 1;
    body_.assign(layout_->tile_count(), 0);
    body_[0] = 1;
    body_.resize(layout_->tile_count() + size_t{3} * width_bytes(layout_->tile_size(0)), 0);
  }

  Status decode_status(const std::vector<uint8_t>& body) {
    header_.body_bytes = static_cast<uint32_t>(body.size());
    return decode_with_header(body);
  }
  Status decode_with_header(const std::vector<uint8_t>& body) {
    std::vector<uint8_t> frame(kFrameHeaderBytes);
    append_compressed(body, 1, frame);
    seal_frame(header_, frame);
    return decoder_.decode(frame).status();
  }

  std::shared_ptr<const FrameLayout> layout_ = small_layout(FrameContent::kCoefficients);
  FrameDecoder decoder_{layout_};
  FrameHeader header_;
  std::vector<uint8_t> body_;  // a correct body of zeros
};

TEST_F(HostileFrame, TheBodyBeforeItIsSpoiltIsGood) {
  EXPECT_TRUE(decode_status(body_).is_ok());
}

TEST_F(HostileFrame, AnEmptyBodyIsRefused) {
  EXPECT_EQ(decode_status({}).code(), StatusCode::kDataLoss);
}

TEST_F(HostileFrame, AWidthAboveSixIsRefused) {
  body_[layout_->tile_count() + 5] = 0x70;
  EXPECT_THAT(decode_status(body_).message(),
              HasSubstr("frame 1: a group has width 7, the largest is 6"));
}

TEST_F(HostileFrame, StreamsShorterThanTheirWidthsAreRefused) {
  body_[layout_->tile_count() + 5] = 0x04;
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("16 bytes, but only 0 are left"));
}

TEST_F(HostileFrame, BytesBehindTheLastStreamAreRefused) {
  body_.push_back(0);
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("1 bytes follow the last stream"));
}

TEST_F(HostileFrame, ATileThatIsNeitherSentNorNotIsRefused) {
  body_[1] = 2;
  EXPECT_THAT(decode_status(body_).message(), HasSubstr("marked 2, not 0 or 1"));
}

TEST_F(HostileFrame, AWrongCountOfTilesIsRefused) {
  header_.sent_tiles = 2;
  EXPECT_THAT(decode_status(body_).message(),
              HasSubstr("1 tiles are marked as sent, the header says 2"));
}

TEST_F(HostileFrame, ABodyLargerThanTheLayoutAllowsIsRefusedBeforeItIsUnpacked) {
  header_.body_bytes = static_cast<uint32_t>(body_bytes_max(*layout_)) + 1;
  EXPECT_THAT(decode_with_header(body_).message(), HasSubstr("bytes, the limit is"));
}

TEST_F(HostileFrame, ABodyOfAnotherLengthThanTheHeaderSaysIsRefused) {
  header_.body_bytes = static_cast<uint32_t>(body_.size()) + 1;
  EXPECT_THAT(decode_with_header(body_).message(),
              HasSubstr("not one zstd frame of " + std::to_string(body_.size() + 1)));
  header_.body_bytes = static_cast<uint32_t>(body_.size()) - 1;
  EXPECT_THAT(decode_with_header(body_).message(),
              HasSubstr("not one zstd frame of " + std::to_string(body_.size() - 1)));
}

TEST_F(HostileFrame, LargestResidualsEverywhereWrapAround) {
  FrameBodyWriter writer(*layout_);
  for (int tile = 0; tile < layout_->tile_count(); ++tile)
    writer.add_tile(tile, std::vector<uint32_t>(size_t{3} * layout_->tile_size(tile), ~0u));
  header_.sent_tiles = writer.sent_tiles();
  header_.step_shift = kStepShiftMax;
  const std::vector<uint8_t> body = writer.bytes();
  EXPECT_LE(body.size(), body_bytes_max(*layout_));
  EXPECT_TRUE(decode_status(body).is_ok());
}

TEST_F(HostileFrame, ARefusedFrameChangesNothing) {
  FrameEncoder encoder(layout_);
  const auto sample = sample_of(*layout_, wavy_displacement(small_scan().grid, 2, 0));
  ASSERT_TRUE(decoder_.decode(encoder.encode(sample, FrameStep::kStill).bytes).is_ok());
  header_.sequence = 2;
  body_.push_back(0);
  EXPECT_FALSE(decode_status(body_).is_ok());
  EXPECT_EQ(steps_of(*layout_, decoder_.state()), sample.steps);
  encoder.acknowledge(1);
  EXPECT_TRUE(decoder_.decode(encoder.encode(sample, FrameStep::kStill).bytes).is_ok());
}

}  // namespace
}  // namespace burnish
