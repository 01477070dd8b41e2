#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/frame_codec/frame_decoder.h"
#include "common/frame_codec/frame_encoder.h"
#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

using testing::HasSubstr;

/// One encoder, one decoder, and the displacement that they carry.
class FrameCodec : public testing::TestWithParam<FrameContent> {
 protected:
  FrameSample wave(double phase, double amplitude = 3) const {
    return sample_of(*layout_, wavy_displacement(small_scan().grid, amplitude, phase));
  }
  DecodedFrame send(const FrameSample& sample, FrameStep step) {
    const EncodedFrame frame = encoder_.encode(sample, step);
    DecodedFrame decoded = decoder_.decode(frame.bytes).value();
    encoder_.acknowledge(frame.sequence);
    return decoded;
  }
  std::vector<int32_t> shown() const { return steps_of(*layout_, decoder_.state()); }

  std::shared_ptr<const FrameLayout> layout_ = small_layout(GetParam());
  FrameEncoder encoder_{layout_};
  FrameDecoder decoder_{layout_};
};

TEST_P(FrameCodec, AStillKeyFrameIsTheRoundedDisplacement) {
  const DecodedFrame decoded = send(wave(0.1), FrameStep::kStill);
  EXPECT_TRUE(decoded.is_key);
  EXPECT_TRUE(decoded.is_still);
  EXPECT_EQ(shown(), wave(0.1).steps);
}

TEST_P(FrameCodec, AStillFrameAfterMovingOnesIsTheRoundedDisplacement) {
  for (int i = 0; i < 5; ++i) send(wave(0.02 * i), FrameStep::kMoving);
  EXPECT_NE(shown(), wave(0.08).steps);
  const DecodedFrame decoded = send(wave(0.08), FrameStep::kStill);
  EXPECT_FALSE(decoded.is_key);
  EXPECT_EQ(shown(), wave(0.08).steps);
}

TEST_P(FrameCodec, AMovingFrameIsWithinTheSlackOfEachValue) {
  for (int i = 0; i < 3; ++i) send(wave(0.5 * i), FrameStep::kMoving);
  const FrameSample wanted = wave(1);
  const std::vector<int32_t> held = shown();
  for (int tile = 0; tile < layout_->tile_count(); ++tile) {
    const size_t begin = layout_->tile_begin(tile), size = layout_->tile_size(tile);
    for (size_t i = 0; i < 3 * size; ++i)
      ASSERT_LE(std::abs(held[3 * begin + i] - wanted.steps[3 * begin + i]),
                2 * layout_->slack[begin + i % size]);
  }
}

TEST(FrameCodecOfCoefficients, AMovingFrameIsWithinA64thOfACellAtEveryVertex) {
  const SmallScan& scan = small_scan();
  const auto layout = small_layout(FrameContent::kCoefficients);
  FrameEncoder encoder(layout);
  FrameDecoder decoder(layout);
  std::vector<Vec3f> shown(scan.grid.corners.size(), Vec3f::Zero());
  for (int i = 0; i < 6; ++i) {
    const auto wanted = wavy_displacement(scan.grid, 3, 0.05 * i);
    const EncodedFrame frame = encoder.encode(sample_of(*layout, wanted), FrameStep::kMoving);
    encoder.acknowledge(frame.sequence);
    const DecodedFrame decoded = decoder.decode(frame.bytes).value();
    for (const int tile : decoded.changed_tiles)
      write_displacement(*layout, decoder.state(), tile, shown);
    for (const EvaluationPoint& point : scan.points) {
      const Vec3d at_vertex = evaluate<Vec3f>(scan.grid, point, shown).cast<double>();
      const Vec3d off = at_vertex - evaluate<Vec3d>(scan.grid, point, wanted);
      ASSERT_LE(off.lpNorm<Eigen::Infinity>(), 1.0 / 64 + 0.5 / 256 + 1e-5);
    }
  }
}

TEST_P(FrameCodec, WhatDoesNotMoveIsNotSent) {
  send(wave(0.3), FrameStep::kStill);
  const EncodedFrame frame = encoder_.encode(wave(0.3), FrameStep::kStill);
  EXPECT_EQ(frame.sent_tiles, 0u);
  EXPECT_LT(frame.bytes.size(), 100u);
  const auto decoded = decoder_.decode(frame.bytes);
  ASSERT_TRUE(decoded.is_ok());
  EXPECT_THAT(decoded->changed_tiles, testing::IsEmpty());
  EXPECT_EQ(shown(), wave(0.3).steps);
}

TEST_P(FrameCodec, OnlyTheTileThatMovesIsSent) {
  FrameSample sample = wave(0.3);
  send(sample, FrameStep::kStill);
  sample.steps[size_t{3} * layout_->tile_begin(1) + 5] += 100;
  EXPECT_THAT(send(sample, FrameStep::kMoving).changed_tiles, testing::ElementsAre(1));
}

TEST_P(FrameCodec, DisplacementsBeyondSixteenBitsAreExact) {
  FrameSample sample = wave(0.3);
  send(sample, FrameStep::kMoving);
  sample.steps[10] = 1 << 28;
  sample.steps[11] = -(1 << 28);
  sample.steps[3000] = 40000;
  send(sample, FrameStep::kStill);
  EXPECT_EQ(shown(), sample.steps);
}

TEST_P(FrameCodec, AMovingFrameThatIsToBeSmallIsRoundedMoreCoarsely) {
  const EncodedFrame fine = encoder_.encode(wave(0.3), FrameStep::kMoving);
  const EncodedFrame small = encoder_.encode(wave(0.3), FrameStep::kMoving, 1);
  EXPECT_TRUE(small.is_complete);
  EXPECT_LT(small.bytes.size(), 0.8 * fine.bytes.size());
  ASSERT_TRUE(decoder_.decode(small.bytes).is_ok());
  const std::vector<int32_t> wanted = wave(0.3).steps, held = shown();
  for (int tile = 0; tile < layout_->tile_count(); ++tile) {
    const size_t begin = layout_->tile_begin(tile), size = layout_->tile_size(tile);
    for (size_t i = 0; i < 3 * size; ++i)
      ASSERT_LE(std::abs(held[3 * begin + i] - wanted[3 * begin + i]),
                32 * layout_->slack[begin + i % size]);  // half of 1/4 cell
  }
}

TEST_P(FrameCodec, AStillFrameThatIsToBeSmallComesInParts) {
  size_t parts = 0;
  for (bool is_complete = false; !is_complete; ++parts) {
    const EncodedFrame part = encoder_.encode(wave(0.3), FrameStep::kStill, 1);
    ASSERT_TRUE(decoder_.decode(part.bytes).is_ok());
    encoder_.acknowledge(part.sequence);
    is_complete = part.is_complete;
    ASSERT_LE(part.sent_tiles, 1u);
  }
  EXPECT_EQ(shown(), wave(0.3).steps);
  EXPECT_GE(parts, static_cast<size_t>(layout_->tile_count()));
}

TEST_P(FrameCodec, ADeltaIsSmallerThanAKeyFrame) {
  const size_t key = encoder_.encode(wave(0.3), FrameStep::kMoving).bytes.size();
  encoder_.acknowledge(1);
  EXPECT_LT(encoder_.encode(wave(0.31), FrameStep::kMoving).bytes.size(), key / 2);
}

TEST_P(FrameCodec, UntilTheFirstAcknowledgementAllFramesAreKeyFrames) {
  EXPECT_EQ(encoder_.encode(wave(0.1), FrameStep::kMoving).reference, 0u);
  EXPECT_EQ(encoder_.encode(wave(0.2), FrameStep::kMoving).reference, 0u);
  encoder_.acknowledge(1);
  EXPECT_EQ(encoder_.encode(wave(0.3), FrameStep::kMoving).reference, 1u);
}

TEST_P(FrameCodec, TheReferenceIsTheNewestAcknowledgedFrame) {
  for (int i = 0; i < 4; ++i) encoder_.encode(wave(0.1 * i), FrameStep::kMoving);
  encoder_.acknowledge(3);
  encoder_.acknowledge(2);  // late: overtaken by another
  EXPECT_EQ(encoder_.encode(wave(0.5), FrameStep::kMoving).reference, 3u);
}

TEST_P(FrameCodec, AFrameWithoutItsReferenceIsRefusedAndTheNextOneHelps) {
  send(wave(0.1), FrameStep::kMoving);
  const EncodedFrame lost = encoder_.encode(wave(0.2), FrameStep::kMoving);
  encoder_.acknowledge(lost.sequence);  // a wrong acknowledgement
  const EncodedFrame refused = encoder_.encode(wave(0.3), FrameStep::kMoving);
  const Status status = decoder_.decode(refused.bytes).status();
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("frame 3: its reference, frame 2, is not held here"));

  encoder_.refuse(refused.sequence);
  const EncodedFrame next = encoder_.encode(wave(0.4), FrameStep::kStill);
  EXPECT_EQ(next.reference, 1u);
  ASSERT_TRUE(decoder_.decode(next.bytes).is_ok());
  EXPECT_EQ(shown(), wave(0.4).steps);
}

TEST_P(FrameCodec, WithoutAnOlderReferenceARefusalBringsAKeyFrame) {
  encoder_.encode(wave(0.1), FrameStep::kMoving);
  encoder_.acknowledge(1);
  const EncodedFrame refused = encoder_.encode(wave(0.2), FrameStep::kMoving);
  encoder_.refuse(refused.sequence);
  EXPECT_EQ(encoder_.encode(wave(0.3), FrameStep::kMoving).reference, 0u);
}

TEST_P(FrameCodec, AKeyFrameComesOnRequest) {
  send(wave(0.1), FrameStep::kMoving);
  encoder_.request_key_frame();
  const EncodedFrame frame = encoder_.encode(wave(0.2), FrameStep::kStill);
  EXPECT_EQ(frame.reference, 0u);
  FrameDecoder fresh(layout_);
  ASSERT_TRUE(fresh.decode(frame.bytes).is_ok());
  EXPECT_EQ(steps_of(*layout_, fresh.state()), wave(0.2).steps);
}

TEST_P(FrameCodec, ALateFrameIsNotShown) {
  const EncodedFrame first = encoder_.encode(wave(0.1), FrameStep::kStill);
  const EncodedFrame second = encoder_.encode(wave(0.2), FrameStep::kStill);
  ASSERT_TRUE(decoder_.decode(second.bytes).is_ok());
  EXPECT_EQ(decoder_.decode(first.bytes).status().code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(decoder_.decode(second.bytes).status().code(), StatusCode::kAlreadyExists);
  EXPECT_EQ(shown(), wave(0.2).steps);
}

TEST_P(FrameCodec, TheSameNumberOfAnotherStreamIsNoReference) {
  send(wave(0.1), FrameStep::kMoving);
  FrameEncoder other(layout_);
  other.encode(wave(0.7), FrameStep::kMoving);
  other.acknowledge(1);
  EXPECT_EQ(decoder_.decode(other.encode(wave(0.8), FrameStep::kMoving).bytes).status().code(),
            StatusCode::kFailedPrecondition);
}

TEST_P(FrameCodec, AFrameOfAnotherLayoutIsRefused) {
  FrameEncoder other(small_layout(GetParam() == FrameContent::kVertices
                                      ? FrameContent::kCoefficients
                                      : FrameContent::kVertices));
  const auto sample =
      sample_of(*small_layout(GetParam() == FrameContent::kVertices ? FrameContent::kCoefficients
                                                                    : FrameContent::kVertices),
                wavy_displacement(small_scan().grid, 1, 0));
  EXPECT_EQ(decoder_.decode(other.encode(sample, FrameStep::kMoving).bytes).status().code(),
            StatusCode::kInvalidArgument);
}

TEST_P(FrameCodec, AClientThatNeverAcknowledgesCostsBoundedMemory) {
  for (size_t i = 0; i < kFramesInFlightMax; ++i)
    encoder_.encode(wave(0.1 * static_cast<double>(i)), FrameStep::kMoving);
  const uint64_t full = encoder_.byte_count();
  for (int i = 0; i < 20; ++i) encoder_.encode(wave(0.1 * i), FrameStep::kMoving);
  EXPECT_EQ(encoder_.byte_count(), full);
}

TEST_P(FrameCodec, AnEncoderHoldsUpToItsBoundAndNoMore) {
  const uint64_t bound = FrameEncoder::byte_count_max(*layout_);
  for (int i = 0; i < 12; ++i) {
    const EncodedFrame frame = encoder_.encode(wave(0.1 * i), FrameStep::kMoving);
    if (i < 2) encoder_.acknowledge(frame.sequence);
    EXPECT_LE(encoder_.byte_count(), bound);
  }
  EXPECT_EQ(encoder_.byte_count(), bound);
}

TEST_P(FrameCodec, TheSameInputGivesTheSameBytes) {
  FrameEncoder again(layout_);
  EXPECT_EQ(encoder_.encode(wave(0.1), FrameStep::kMoving).bytes,
            again.encode(wave(0.1), FrameStep::kMoving).bytes);
}

INSTANTIATE_TEST_SUITE_P(Contents, FrameCodec,
                         testing::Values(FrameContent::kCoefficients, FrameContent::kVertices),
                         [](const auto& test) {
                           return test.param == FrameContent::kVertices ? "Vertices"
                                                                        : "Coefficients";
                         });

}  // namespace
}  // namespace burnish
