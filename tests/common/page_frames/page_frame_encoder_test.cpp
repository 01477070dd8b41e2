#include "common/page_frames/page_frame_encoder.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/page_frames/page_frame_decoder.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A client that shows pages 0 to 9 and acknowledges each frame.
class PageFrames : public testing::TestWithParam<PageFrameKind> {
 protected:
  PageFrames() { show({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}); }

  void show(const std::vector<PageId>& added, std::vector<PageId> removed = {}) {
    PageChange change = sampler_.adding(shown_.revision() + 1, added);
    change.removed = std::move(removed);
    ASSERT_TRUE(decoder_.show(change, sampler_.page_count()).is_ok());
    shown_ = shown_.changed(change);
  }

  EncodedPageFrame encode(const StepChoice& steps) {
    return encoder_.encode({shown_, sampler_.wanted(shown_), 1.5F}, steps);
  }

  DecodedPageFrame send(const StepChoice& steps = kStillSteps) {
    sent_ = encode(steps);
    const auto decoded = decoder_.decode(sent_.bytes);
    EXPECT_TRUE(decoded.is_ok()) << decoded.status().message();
    encoder_.acknowledge(sent_.sequence);
    return *decoded;
  }

  std::vector<int32_t> held(PageId page) const {
    const PageTile* tile = decoder_.state().find(page);
    std::vector<int32_t> values(tile->value_count());
    tile->read(values);
    return values;
  }

  PageSampler sampler_{GetParam()};
  ShownPages shown_;
  PageFrameEncoder encoder_{GetParam()};
  PageFrameDecoder decoder_{GetParam()};
  EncodedPageFrame sent_;
};

TEST_P(PageFrames, AStillFrameIsExactlyTheSample) {
  sampler_.sample(wavy_field(3, 0));
  const DecodedPageFrame frame = send();
  EXPECT_TRUE(frame.is_key);
  EXPECT_EQ(frame.step_shift, 0);
  EXPECT_EQ(frame.largest_move, 1.5F);
  EXPECT_EQ(frame.changed_pages.size(), 10u);
  for (PageId page = 0; page < 10; ++page) EXPECT_EQ(held(page), rounded(sampler_.steps(page), 0));
}

TEST_P(PageFrames, AnEncoderThatReplacesAnotherGoesOnWithItsNumbers) {
  sampler_.sample(wavy_field(3, 0));
  send();
  encoder_ = PageFrameEncoder(GetParam(), encoder_.next_sequence());
  encoder_.acknowledge(1);  // a frame of the other encoder
  EXPECT_TRUE(send().is_key);
  EXPECT_EQ(sent_.sequence, 2u);
}

TEST_P(PageFrames, AGainAloneIsNewsWithoutPages) {
  sampler_.sample(wavy_field(3, 0));
  send();
  EXPECT_EQ(sent_.sent_gains, 0u);
  std::vector<WantedPage> wanted = sampler_.wanted(shown_);
  wanted[3].gain = 2;
  const EncodedPageFrame frame = encoder_.encode({shown_, wanted, 1.5F}, kStillSteps);
  EXPECT_EQ(frame.sent_pages, 0u);
  EXPECT_EQ(frame.sent_gains, 1u);
}

TEST_P(PageFrames, HeldVerticesAreNewsOnceAndLast) {
  sampler_.sample(wavy_field(3, 0));
  send();
  std::vector<WantedPage> wanted = sampler_.wanted(shown_);
  const size_t bytes = held_bytes(shown_.pages()[3].layout->vertices);
  const auto held = std::make_shared<const std::vector<uint8_t>>(bytes, 1);
  const auto send_wanted = [&] {
    sent_ = encoder_.encode({shown_, wanted, 1.5F}, kStillSteps);
    encoder_.acknowledge(sent_.sequence);
    return decoder_.decode(sent_.bytes)->changed_pages;
  };
  wanted[3].held = held;
  EXPECT_THAT(send_wanted(), ElementsAre(3));
  EXPECT_EQ(sent_.sent_pages, 0u);
  EXPECT_EQ(sent_.sent_held, 1u);
  EXPECT_EQ(*decoder_.state().find(3)->held, *held);
  wanted[3].held = std::make_shared<const std::vector<uint8_t>>(*held);
  EXPECT_THAT(send_wanted(), IsEmpty());
  EXPECT_EQ(sent_.sent_held, 0u);
  wanted[3].held = nullptr;
  EXPECT_THAT(send_wanted(), ElementsAre(3));
  EXPECT_EQ(decoder_.state().find(3)->held, nullptr);
}

TEST_P(PageFrames, AStillViewSendsNoPagesAndFewBytes) {
  sampler_.sample(wavy_field(3, 0));
  send();
  EXPECT_THAT(send().changed_pages, IsEmpty());
  EXPECT_EQ(sent_.sent_pages, 0u);
  EXPECT_LT(sent_.bytes.size(), kPageFrameHeaderBytes + 30);
}

TEST_P(PageFrames, AMovingFrameIsRoundedToItsStep) {
  sampler_.sample(wavy_field(3, 0));
  EXPECT_EQ(send(moving_steps(SIZE_MAX)).step_shift, 2);
  for (PageId page = 0; page < 10; ++page) EXPECT_EQ(held(page), rounded(sampler_.steps(page), 2));
}

TEST_P(PageFrames, AMovingFrameTooLargeForTheLinkTakesCoarserSteps) {
  sampler_.sample(wavy_field(3, 0));
  send();
  sampler_.sample(wavy_field(3.3, 0.1));
  const size_t bytes = encode(moving_steps(SIZE_MAX)).bytes.size();
  const DecodedPageFrame coarser = send(moving_steps(bytes));
  EXPECT_GT(coarser.step_shift, 2);
  EXPECT_LT(coarser.step_shift, 6);
  sampler_.sample(wavy_field(3.6, 0.2));
  EXPECT_EQ(send(moving_steps(1)).step_shift, 6);
  for (PageId page = 0; page < 10; ++page) EXPECT_EQ(held(page), rounded(sampler_.steps(page), 6));
}

TEST_P(PageFrames, AStillFrameIsCompleteWhateverItsSize) {
  sampler_.sample(wavy_field(3, 0));
  EXPECT_EQ(send({.bytes_max = 1}).step_shift, 0);
  for (PageId page = 0; page < 10; ++page) EXPECT_EQ(held(page), rounded(sampler_.steps(page), 0));
}

TEST_P(PageFrames, ADabSendsOnlyThePagesThatItTouches) {
  std::vector<PageId> all(sampler_.page_count() - 10);
  std::iota(all.begin(), all.end(), PageId{10});
  show(all);
  auto field = wavy_field(3, 0);
  sampler_.sample(field);
  send();
  std::vector<std::vector<int32_t>> before;
  for (PageId page = 0; page < sampler_.page_count(); ++page) before.push_back(held(page));
  std::mt19937 random(3);
  dab_field(random, 1, field);
  sampler_.sample(field);
  std::vector<PageId> touched;
  for (PageId page = 0; page < sampler_.page_count(); ++page)
    if (rounded(sampler_.steps(page), 0) != before[page]) touched.push_back(page);
  const DecodedPageFrame frame = send({.finest = 0, .coarsest = 6, .bytes_max = 1 << 20});
  EXPECT_EQ(frame.changed_pages, touched);
  EXPECT_EQ(sent_.sent_pages, touched.size());
  EXPECT_GT(touched.size(), 0u);
  EXPECT_LT(touched.size(), before.size() / 2);
}

TEST_P(PageFrames, AFrameOfAQuarterOfThePagesIsNotRoundedWhateverItsSize) {
  sampler_.sample(wavy_field(3, 0));
  send();
  std::vector<WantedPage> wanted = sampler_.wanted(shown_);
  std::vector<std::vector<int32_t>> moved;
  for (const PageId page : {3, 5, 7}) {
    moved.emplace_back(wanted[page].steps.begin(), wanted[page].steps.end());
    for (int32_t& step : moved.back()) step += 5;
  }
  const StepChoice steps{.finest = 0, .coarsest = 6, .bytes_max = 1};
  wanted[3].steps = moved[0];
  wanted[5].steps = moved[1];
  const EncodedPageFrame two = encoder_.encode({shown_, wanted, 1.5F}, steps);
  EXPECT_EQ(two.step_shift, 0);
  EXPECT_EQ(two.sent_pages, 2u);
  wanted[7].steps = moved[2];
  EXPECT_EQ(encoder_.encode({shown_, wanted, 1.5F}, steps).step_shift, 6);
}

TEST_P(PageFrames, APageShownLaterHasTheValuesThatItWouldAlwaysHaveHad) {
  PageFrameEncoder always(GetParam());
  const ShownPages all = shown_.changed(sampler_.adding(2, {20}));
  for (const double amplitude : {3.0, 3.5, 3.7}) {
    if (amplitude == 3.7) show({20});
    sampler_.sample(wavy_field(amplitude, 0.2));
    send(moving_steps(SIZE_MAX));
    always.acknowledge(always.encode({all, sampler_.wanted(all)}, moving_steps(SIZE_MAX)).sequence);
  }
  EXPECT_EQ(values_of(decoder_.state()), values_of(*always.sent_state(3)));
}

TEST_P(PageFrames, AShownPageComesWithTheNextFrameAndAHiddenOneGoes) {
  sampler_.sample(wavy_field(3, 0));
  send();
  show({12}, {3});
  const DecodedPageFrame frame = send();
  EXPECT_EQ(frame.revision, 2u);
  EXPECT_THAT(frame.changed_pages, ElementsAre(12));
  EXPECT_EQ(sent_.sent_pages, 1u);
  EXPECT_EQ(held(12), rounded(sampler_.steps(12), 0));
  EXPECT_EQ(decoder_.state().find(3), nullptr);
}

TEST_P(PageFrames, FramesOfAnOlderRevisionAreShownUntilTheServerHears) {
  sampler_.sample(wavy_field(3, 0));
  const EncodedPageFrame old = encode(kStillSteps);
  show({12});
  const auto decoded = decoder_.decode(old.bytes);
  ASSERT_TRUE(decoded.is_ok()) << decoded.status().message();
  EXPECT_EQ(decoded->revision, 1u);
  EXPECT_EQ(send().revision, 2u);
}

TEST_P(PageFrames, ATooLargeNumberOfOpenChangesIsRefused) {
  PageChange change{.revision = 1};
  for (size_t i = 1; i < kPageChangesInFlightMax; ++i) {
    change.revision = shown_.revision() + static_cast<uint32_t>(i);
    ASSERT_TRUE(decoder_.show(change, sampler_.page_count()).is_ok());
  }
  ++change.revision;
  EXPECT_EQ(decoder_.show(change, sampler_.page_count()).code(), StatusCode::kResourceExhausted);
  send();
  EXPECT_TRUE(decoder_.show(change, sampler_.page_count()).is_ok());
}

TEST_P(PageFrames, TheGainIsSentWhenItChanges) {
  sampler_.sample(wavy_field(3, 0));
  send();
  auto wanted = sampler_.wanted(shown_);
  wanted[4].gain = 3;
  for (const size_t bytes_more : {1, 0}) {
    const EncodedPageFrame frame = encoder_.encode({shown_, wanted}, kStillSteps);
    EXPECT_EQ(read_page_frame_header(frame.bytes)->body_bytes, 10 + bytes_more);
    ASSERT_TRUE(decoder_.decode(frame.bytes).is_ok());
    encoder_.acknowledge(frame.sequence);
    EXPECT_EQ(decoder_.state().find(4)->gain, 3);
    EXPECT_EQ(decoder_.state().find(5)->gain, 0);
  }
}

TEST_P(PageFrames, AClientThatHoldsNothingGetsAKeyFrame) {
  sampler_.sample(wavy_field(3, 0));
  send();
  decoder_ = PageFrameDecoder(GetParam(), shown_);
  encoder_.request_key_frame();
  EXPECT_TRUE(send().is_key);
  EXPECT_EQ(held(7), rounded(sampler_.steps(7), 0));
}

TEST_P(PageFrames, ARefusedFrameIsFollowedByOneThatDecodes) {
  sampler_.sample(wavy_field(3, 0));
  send();
  decoder_ = PageFrameDecoder(GetParam(), shown_);
  const EncodedPageFrame refused = encode(kStillSteps);
  EXPECT_EQ(decoder_.decode(refused.bytes).status().code(), StatusCode::kFailedPrecondition);
  encoder_.refuse(refused.sequence);
  EXPECT_TRUE(send().is_key);
}

TEST_P(PageFrames, ALateFrameIsDropped) {
  const EncodedPageFrame late = encode(kStillSteps);
  sampler_.sample(wavy_field(3, 0));
  send();
  EXPECT_EQ(decoder_.decode(late.bytes).status().code(), StatusCode::kAlreadyExists);
}

TEST_P(PageFrames, MemoryStaysWithinItsLimit) {
  for (int i = 0; i < 30; ++i) {
    sampler_.sample(wavy_field(3, 0.1 * i));
    const EncodedPageFrame frame = encode(kStillSteps);
    if (i < 2) encoder_.acknowledge(frame.sequence);
  }
  EXPECT_LE(encoder_.byte_count(), PageFrameEncoder::byte_count_max(shown_.pages()));
  EXPECT_GT(encoder_.byte_count(), PageFrameEncoder::byte_count_max(shown_.pages()) * 9 / 10);
}

TEST_P(PageFrames, AMovementBeyondTwoBytesComesBack) {
  sampler_.sample(wavy_field(200, 0));
  send();
  EXPECT_EQ(held(7), rounded(sampler_.steps(7), 0));
}

INSTANTIATE_TEST_SUITE_P(Kinds, PageFrames,
                         testing::Values(PageFrameKind::kVertices, PageFrameKind::kCorners));

}  // namespace
}  // namespace burnish
