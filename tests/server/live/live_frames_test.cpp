// The content of a live session's frames, and the times when they go out.

#include <gtest/gtest.h>

#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using LiveFrames = LiveWork;

TEST_F(LiveFrames, SettledEveryClientHoldsTheRoundedDisplacement) {
  auto whole = guest(), proxy = guest("bob", {"work", 200}),
       vertices = guest("eve", {"work", 0, FrameContent::kVertices});
  whole.edit({{"a", stroke()}, {"b", SetTransferCurve{TransferCurve(20)}}});
  for (LiveGuest* each : {&whole, &proxy, &vertices}) each->settle();
  for (LiveGuest* each : {&whole, &proxy, &vertices})
    EXPECT_EQ(shown(*each).steps, sample(*each).steps);
}

TEST_F(LiveFrames, WhileItMovesAFrameIsOffByAtMostTheCodecsStep) {
  auto ann = guest("ann", {"work", 0, FrameContent::kVertices});
  ann.edit({{"a", SetGradientScale{0}}});
  ann.subscriber().grant({.frames = 1});
  ASSERT_TRUE(live_->scheduler().run_one());
  const FrameSample exact = sample(ann);
  while (ann.decoded.empty()) ann.run();
  ASSERT_EQ(ann.all<LiveFrame>().size(), 1u);
  EXPECT_FALSE(ann.all<LiveFrame>()[0].stats.settled);
  const FrameSample seen = shown(ann);
  for (size_t i = 0; i < exact.steps.size(); ++i)
    ASSERT_LE(std::abs(exact.steps[i] - seen.steps[i]), 2);  // half of 1/64 cell
}

TEST_F(LiveFrames, OverASlowLinkASettledSurfaceIsShownInPartsAndExactInTheEnd) {
  ASSERT_TRUE(library_.import(sphere_file(1, 5), "large").is_ok());
  ASSERT_TRUE(manager_->open({"large", "large", {5, 0}}, "ann", {}).is_ok());
  const Greeting wish{"large", 0, FrameContent::kVertices};  // with several tiles
  auto ann = guest("ann", wish), bob = guest("bob", wish);
  ann.edit({{"a", SetGradientScale{0}}});
  bob.settle();
  size_t parts = 0;
  for (;; ++parts) {
    ann.run();
    const auto frames = ann.all<LiveFrame>();
    if (!frames.empty() && frames.back().stats.settled && ann.decoded.empty()) break;
    ASSERT_LT(parts, 100u);
    ann.subscriber().grant(
        {.frames = 1, .decoded = std::exchange(ann.decoded, {}), .frame_bytes = 1000});
  }
  EXPECT_EQ(shown(ann).steps, shown(bob).steps);
  EXPECT_GE(parts, 4u);
}

TEST_F(LiveFrames, WithoutAnAcknowledgementOneKeyFrameGoesOut) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.subscriber().grant({.frames = 8});
  ann.run();
  EXPECT_EQ(ann.all<LiveFrame>().size(), 1u);
  ann.subscriber().grant({.decoded = ann.decoded});
  ann.run();
  EXPECT_GT(ann.all<LiveFrame>().size(), 1u);
}

TEST_F(LiveFrames, NoFrameGoesOutWithoutACredit) {
  auto ann = guest();
  ann.run();
  EXPECT_TRUE(ann.all<LiveFrame>().empty());
  for (int frames = 1; frames <= 3; ++frames) {
    ann.edit({{"e" + std::to_string(frames), SetGradientScale{0.1 * frames}}});
    ann.subscriber().grant({.frames = 1, .decoded = std::exchange(ann.decoded, {})});
    ann.run();
    EXPECT_EQ(ann.all<LiveFrame>().size(), static_cast<size_t>(frames));
  }
  ann.subscriber().grant({.frames = 1000});
  EXPECT_EQ(ann.subscriber().credits(), kCreditsMax);
}

TEST_F(LiveFrames, SettledItIsSilentUntilSomethingChanges) {
  auto ann = guest();
  ann.settle();
  ann.subscriber().grant({.frames = 8});
  ann.run();
  const size_t frames = ann.all<LiveFrame>().size();
  const int cycles = ann.all<LiveFrame>().back().stats.cycles;
  for (int i = 0; i < 3; ++i) ann.run();
  EXPECT_EQ(ann.all<LiveFrame>().size(), frames);
  EXPECT_EQ(live_->scheduler().waiting(), 0u);
  ann.edit({{"a", SetGradientScale{0.5}}});
  ann.settle();
  EXPECT_GT(ann.all<LiveFrame>().back().stats.cycles, cycles);
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.edits, 1u);
}

TEST_F(LiveFrames, WhatAnExactExportRelaxedIsShownAsExact) {
  auto ann = guest();
  ann.edit({{"a", stroke()}});  // a slider alone would be exact at once
  ann.settle();
  EXPECT_FALSE(ann.all<LiveFrame>().back().stats.exact);
  ASSERT_TRUE(
      manager_->export_mesh("work", {.format = MeshFormat::kPly, .exact = true}, {}).is_ok());
  ann.settle();
  EXPECT_TRUE(ann.all<LiveFrame>().back().stats.exact);
  EXPECT_EQ(shown(ann).steps, sample(ann).steps);
  ann.edit({{"b", SetGradientScale{0.5}}});
  ann.settle();
  EXPECT_FALSE(ann.all<LiveFrame>().back().stats.exact);
}

TEST_F(LiveFrames, WhoComesToASettledSurfaceGetsOneStillFrameWithoutACycle) {
  auto ann = guest();
  ann.settle();
  const int cycles = ann.all<LiveFrame>().back().stats.cycles;
  auto bob = guest("bob");
  bob.settle();
  ASSERT_EQ(bob.all<LiveFrame>().size(), 1u);
  EXPECT_EQ(bob.all<LiveFrame>()[0].stats.cycles, cycles);
  EXPECT_EQ(shown(bob).steps, sample(bob).steps);
}

TEST_F(LiveFrames, AFrameThatCouldNotBeDecodedIsMadeUpFor) {
  auto ann = guest();
  ann.settle();
  ann.decoder = FrameDecoder(ann.subscriber().target->layout);  // loses everything
  ann.subscriber().grant({.frames = 1, .key_frame = true});
  ann.run();
  EXPECT_EQ(shown(ann).steps, sample(ann).steps);
}

}  // namespace
}  // namespace burnish
