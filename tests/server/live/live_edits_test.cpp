// Edits and gestures of the clients of a live session.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using LiveEdits = LiveWork;

TEST_F(LiveEdits, EditsAreAnsweredOnceOnDiskAllOrNone) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0.5}}, {"b", stroke()}});
  ann.edit({{"c", SetGradientScale{0.25}}, {"d", SwitchEntry{77, false}}});
  ann.edit({{"a", SetGradientScale{0.5}}});
  ann.run();
  const auto answers = ann.all<EditsAcknowledged>();
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_THAT(answers[0].edit_ids, ElementsAre("a", "b"));
  EXPECT_THAT(answers[0].outcome.entries, ElementsAre(1u, 2u));
  EXPECT_EQ(answers[1].outcome.known, 1u);
  const auto refused = ann.all<EditsRefused>();
  ASSERT_EQ(refused.size(), 1u);
  EXPECT_THAT(refused[0].edit_ids, ElementsAre("c", "d"));
  EXPECT_EQ(refused[0].status.code(), StatusCode::kNotFound);
  const std::string id = manager_->list()[0].id;
  EXPECT_EQ(journal_->edits(id).value().size(), 2u);
  EXPECT_EQ(ann.all<HistoryState>().back(),
            (HistoryState{2, {0.5, TransferCurve(50), kNewSessionControls}}));
}

TEST_F(LiveEdits, APreviewReachesEverybodyAndIsGoneWithItsConnection) {
  auto ann = guest(), bob = guest("bob");
  bob.show_level(0);
  bob.settle();
  const std::vector<int32_t> before = bob.pages.values();
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", stroke()}).is_ok());
  bob.subscriber().grant({.frames = 1});
  bob.settle();
  EXPECT_NE(bob.pages.values(), before);
  EXPECT_EQ(bob.all<LiveFrame>().back().stats.edits, 0u);
  ann.leave();
  bob.subscriber().grant({.frames = 1});
  bob.settle();
  const std::vector<int32_t> after = bob.pages.values();
  int worst = 0;
  for (size_t i = 0; i < before.size(); ++i)
    worst = std::max(worst, std::abs(before[i] - after[i]));
  EXPECT_LE(worst, 1);
  EXPECT_EQ(manager_->list()[0].edits, 0u);
}

TEST_F(LiveEdits, APreviewGivesWayToItsEditAndFramesCountIt) {
  auto ann = guest();
  ann.show_level(0);
  ann.settle();
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", SetGradientScale{0.5}}).is_ok());
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.previews, 1u);
  const std::vector<int32_t> dragged = ann.pages.values();
  ann.edit({{"drag", SetGradientScale{0.5}}});
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.edits, 1u);
  EXPECT_EQ(ann.pages.values(), dragged);
}

TEST_F(LiveEdits, APreviewThatEndsBeforeItIsTakenGetsItsFrame) {
  auto ann = guest();
  ann.show_level(0);
  ann.settle();
  const std::vector<int32_t> before = ann.pages.values();
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", SetGradientScale{0.5}}).is_ok());
  ann.session().drop_preview(ann.connection(), "drag");
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.previews, 2u);
  EXPECT_EQ(ann.pages.values(), before);
}

TEST_F(LiveEdits, ARefusedPreviewIsCountedByAFrame) {
  auto ann = guest();
  ann.show_level(0);
  ann.settle();
  EXPECT_FALSE(ann.session().preview(ann.connection(), {"drag", SetGradientScale{-1}}).is_ok());
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.previews, 1u);
}

TEST_F(LiveEdits, AGainMovesTheSurfaceWithoutACycle) {
  const auto bands = [](double gain) { return SetEqualiser{{{{0.5, gain}, {2, gain}}}}; };
  auto ann = guest();
  ann.show_level(0);
  ann.edit({{"bands", bands(1)}});
  ann.settle();
  const std::vector<int32_t> before = ann.pages.values();
  const int cycles = ann.all<LiveFrame>().back().stats.cycles;
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", bands(0)}).is_ok());
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.cycles, cycles);
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.previews, 1u);
  const std::vector<int32_t> dragged = ann.pages.values();
  EXPECT_NE(dragged, before);
  ann.edit({{"drag", bands(0)}});
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.edits, 2u);
  EXPECT_EQ(ann.all<LiveFrame>().back().stats.cycles, cycles);
  EXPECT_EQ(ann.pages.values(), dragged);
  EXPECT_EQ(ann.all<HistoryState>().back().settings.equaliser, bands(0).equaliser);
}

TEST_F(LiveEdits, APreviewOfBandsThatCannotBeIsRefused) {
  auto ann = guest();
  const SetEqualiser bands{{{{0.5, 11}}}};
  const Status status = ann.session().preview(ann.connection(), {"drag", bands});
  EXPECT_THAT(status.message(), HasSubstr("gain 11 is outside 0 to 10"));
}

TEST_F(LiveEdits, AnExportLeavesPreviewsOut) {
  const auto exported = [this] {
    return manager_->export_mesh("work", {MeshFormat::kObj, true, 0}, {}).value()->summary();
  };
  auto ann = guest();
  ann.settle();
  const double energy = exported().energy;
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", SetGradientScale{0}}).is_ok());
  ann.settle();
  EXPECT_NEAR(exported().energy, energy, 1e-6 * std::abs(energy) + 1e-9);
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_NE(ann.all<LiveFrame>().back().stats.energy, energy);
}

TEST_F(LiveEdits, ACancelledExportLeavesNothingUnsolved) {
  ASSERT_TRUE(manager_->apply("work", "ann", std::vector<Edit>{{"a", stroke()}}, {}).is_ok());
  int reports = 0;
  const auto cancelled_at_once = [&](std::string_view, double) { return ++reports < 2; };
  EXPECT_FALSE(manager_->export_mesh("work", {}, {}, cancelled_at_once).is_ok());
  auto ann = guest();
  ann.settle();
  EXPECT_GT(ann.all<LiveFrame>().back().stats.cycles, 2);
  EXPECT_LT(ann.all<LiveFrame>().back().stats.distance, 1e-4);
}

TEST_F(LiveEdits, PreviewsAreCheckedAsAWhole) {
  auto ann = guest();
  const auto grow = [&](const Stroke& piece) {
    return ann.session().preview(ann.connection(), {"drag", piece});
  };
  Stroke fine{{0.001, 1, 0, FallOff::kSmooth}, {{0, 0, 0}}};
  Status status;
  for (int i = 1; i < 100 && status.is_ok(); ++i) {
    fine.path = {{0.1 * (i % 2), 0, 0}};
    status = grow(fine);
  }
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("more than 4096 dabs"));
  fine.brush.radius = 2;
  EXPECT_THAT(grow(fine).message(), HasSubstr("brush of a preview"));
}

TEST_F(LiveEdits, SomebodyElseAtTheSessionHoldsUpOnlyItsOwnTurns) {
  auto ann = guest();
  ann.run();
  ann.edit({{"a", SetGradientScale{0.5}}});
  ASSERT_TRUE(manager_
                  ->visit("work", {},
                          [&](Session&) {
                            while (live_->scheduler().run_one()) {
                            }
                            EXPECT_EQ(ann.session().queued_edits(), 1u);
                            return Status::ok();
                          })
                  .is_ok());
  EXPECT_EQ(live_->scheduler().waiting(), 1u);
  ann.run();
  EXPECT_EQ(ann.all<EditsAcknowledged>().size(), 1u);
}

TEST_F(LiveEdits, EditsAreAnsweredWhileAnExportSolves) {
  live_.reset();
  live_ = std::make_unique<LiveSessions>(*manager_, 1);
  auto ann = guest();
  bool is_sent = false;
  const auto until_answered = [&](std::string_view, double) {
    if (!std::exchange(is_sent, true)) ann.edit({{"a", SetGradientScale{0.5}}});
    ann.take_all();
    return ann.all<EditsAcknowledged>().empty();
  };
  const auto exported = manager_->export_mesh(
      "work", {.format = MeshFormat::kObj, .cycles = 10'000}, {}, until_answered);
  EXPECT_EQ(exported.status().code(), StatusCode::kCancelled);
  EXPECT_EQ(ann.all<EditsAcknowledged>().size(), 1u);
  EXPECT_EQ(manager_->state("work", {}).value().settings.beta, 0.5);
  ann.leave();
}

}  // namespace
}  // namespace burnish
