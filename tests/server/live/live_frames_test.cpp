// The content of a live session's frames, and the times when they go out.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using LiveFrames = LiveWork;

using enum PageFrameKind;

TEST_F(LiveFrames, SettledEveryClientHoldsTheRoundedDisplacement) {
  auto corners = guest("ann", {"work", kCorners}), vertices = guest("bob", {"work", kVertices}),
       coarse = guest("eve");
  for (LiveGuest* each : {&corners, &vertices}) each->show_level(0);
  coarse.show({coarse.pages.head().root()});
  corners.edit({{"a", stroke()}, {"b", SetTransferCurve{TransferCurve(20)}}});
  for (LiveGuest* each : {&corners, &vertices, &coarse}) {
    each->settle();
    EXPECT_EQ(each->pages.values(), sample(*each));
  }
  EXPECT_EQ(corners.pages.kind(), kCorners);
  EXPECT_EQ(vertices.pages.kind(), kVertices);
}

TEST_F(LiveFrames, WhileItMovesAFrameIsOffByAtMostHalfItsStep) {
  auto ann = guest("ann", {"work", kVertices});
  ann.show_level(0);
  ann.run();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.subscriber().grant({.frames = 1});
  ASSERT_TRUE(live_->scheduler().run_one());
  while (ann.frames.empty()) ann.take_all();
  ASSERT_EQ(ann.all<LiveFrame>().size(), 1u);
  EXPECT_FALSE(ann.all<LiveFrame>()[0].stats.settled);
  EXPECT_EQ(ann.frames[0].step_shift, 2);
  const std::vector<int32_t> exact = sample(ann), seen = ann.pages.values();
  for (size_t i = 0; i < exact.size(); ++i)
    ASSERT_LE(std::abs(exact[i] - seen[i]), 2);  // half of 1/64 cell
}

TEST_F(LiveFrames, BeforeTheFirstCycleTheUnmovedSurfaceIsShown) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.show_level(0);
  ann.subscriber().grant({.frames = 1});
  while (ann.frames.empty()) ann.take_all();  // nobody takes a turn
  const auto shown = ann.all<LiveFrame>();
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].stats.cycles, 0);
  EXPECT_EQ(shown[0].stats.edits, 0u);
  EXPECT_FALSE(shown[0].stats.settled);
  EXPECT_EQ(ann.frames[0].step_shift, 0);
  EXPECT_EQ(ann.frames[0].largest_move, 0);
  EXPECT_THAT(ann.pages.values(), testing::Each(0));
  ann.settle();
  EXPECT_GT(ann.frames.back().largest_move, 0);
  EXPECT_EQ(ann.pages.values(), sample(ann));
}

TEST_F(LiveFrames, WhoComesBackToASolvedSessionDoesNotSeeItUnmoved) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.settle();
  ann.leave();
  auto bob = guest("bob");
  bob.show_level(0);
  bob.settle();
  for (const LiveFrame& frame : bob.all<LiveFrame>()) EXPECT_GT(frame.stats.cycles, 0);
}

TEST_F(LiveFrames, OverASlowLinkAMovingSurfaceIsCoarserAndAStillOneExact) {
  auto ann = guest();
  ann.show_level(0);
  ann.settle();
  int coarsest = 0;
  // A small surface may settle before the encoder looks at it; then the next edit moves it again.
  for (uint64_t edits = 1; coarsest == 0 && edits <= 20; ++edits) {
    ann.edit({{std::to_string(edits), SetGradientScale{edits % 2 == 1 ? 0.0 : 1.0}}});
    for (FrameStats stats; !(stats.settled && stats.edits == edits);) {
      ann.subscriber().grant(
          {.frames = 1, .decoded = std::exchange(ann.decoded, {}), .frame_bytes = 100});
      ann.run();
      coarsest = std::max(coarsest, ann.frames.back().step_shift);
      stats = ann.all<LiveFrame>().back().stats;
    }
  }
  EXPECT_EQ(coarsest, 6);
  EXPECT_EQ(ann.frames.back().step_shift, 0);
  EXPECT_EQ(ann.pages.values(), sample(ann));
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
  ann.show_level(0);
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
  ann.show_level(0);
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

TEST_F(LiveFrames, AFrameThatShowsNothingNewCostsNothing) {
  auto ann = guest();
  ann.show_level(0);
  ann.settle();
  const size_t frames = ann.all<LiveFrame>().size(), with_data = ann.frames.size();
  ASSERT_TRUE(manager_->export_mesh("work", {.format = MeshFormat::kPly, .cycles = 2}, {}).is_ok());
  ann.settle();
  EXPECT_GT(ann.all<LiveFrame>().size(), frames);
  EXPECT_EQ(ann.all<LiveFrame>().back().data.size(), 0u);
  EXPECT_EQ(ann.frames.size(), with_data);
}

TEST_F(LiveFrames, WhoShowsNothingHearsOfEditsAndOfTheEnd) {
  auto ann = guest();
  ann.edit({{"a", stroke()}});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.edits, 1u);
  EXPECT_TRUE(ann.pages.values().empty());
  EXPECT_GT(ann.frames.back().largest_move, 0);
}

TEST_F(LiveFrames, WhatAnExactExportRelaxedIsShownAsExact) {
  auto ann = guest();
  ann.show_level(0);
  ann.edit({{"a", stroke()}});  // a slider alone would be exact at once
  ann.settle();
  EXPECT_FALSE(ann.all<LiveFrame>().back().stats.exact);
  ASSERT_TRUE(
      manager_->export_mesh("work", {.format = MeshFormat::kPly, .exact = true}, {}).is_ok());
  ann.settle();
  EXPECT_TRUE(ann.all<LiveFrame>().back().stats.exact);
  EXPECT_EQ(ann.pages.values(), sample(ann));
  ann.edit({{"b", SetGradientScale{0.5}}});
  ann.settle();
  EXPECT_FALSE(ann.all<LiveFrame>().back().stats.exact);
}

TEST_F(LiveFrames, WhoComesToASettledSurfaceGetsOneStillFrameWithoutACycle) {
  auto ann = guest();
  ann.settle();
  const int cycles = ann.all<LiveFrame>().back().stats.cycles;
  auto bob = guest("bob");
  bob.show_level(0);
  bob.settle();
  ASSERT_EQ(bob.all<LiveFrame>().size(), 1u);
  EXPECT_EQ(bob.all<LiveFrame>()[0].stats.cycles, cycles);
  EXPECT_EQ(bob.pages.values(), sample(bob));
}

TEST_F(LiveFrames, AFrameThatCouldNotBeDecodedIsMadeUpFor) {
  auto ann = guest();
  ann.show_level(0);
  ann.edit({{"a", stroke()}});
  ann.settle();
  ann.pages.forget();
  ann.subscriber().grant({.frames = 1, .key_frame = true});
  ann.run();
  EXPECT_TRUE(ann.frames.back().is_key);
  EXPECT_EQ(ann.pages.values(), sample(ann));
}

}  // namespace
}  // namespace burnish
