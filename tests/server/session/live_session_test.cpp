#include "server/session/live_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/session/session_turn.h"
#include "tests/server/session/live_guest.h"
#include "tests/server/session/test_library.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A session "work" of ann's over a sphere, whose turns are taken by the test.
class LiveSessionTest : public testing::Test {
 protected:
  LiveSessionTest() {
    BURNISH_CHECK(library_.import(sphere_file(), "ball").is_ok(), "import");
    journal_ = std::move(Journal::open(library_.folder->journal())).value();
    SessionManagerOptions options;
    options.solver.backend = BackendKind::kCpu;
    options.solver.threads = 1;
    manager_ =
        std::move(SessionManager::create(*library_.folder, *library_.store, *journal_, options))
            .value();
    BURNISH_CHECK(manager_->open({"ball", "work", {5, 0}}, "ann", {}).is_ok(), "open");
    live_ = std::make_unique<LiveSessions>(*manager_, 0);
  }

  LiveGuest guest(const std::string& user = "ann", const LiveGreeting& wish = {"work"}) {
    return LiveGuest(*live_, wish, user);
  }

  std::vector<Vec3f> displacement() {
    std::vector<Vec3f> u;
    EXPECT_TRUE(manager_
                    ->visit("work", {},
                            [&](Session& session) {
                              const auto now = session.solver().displacement();
                              u.assign(now.begin(), now.end());
                              return Status::ok();
                            })
                    .is_ok());
    return u;
  }

  /// What the guest must show of a settled session: the displacement, rounded.
  FrameSample sample(LiveGuest& guest) {
    const FrameTarget& target = *guest.subscriber().target;
    return sample_displacement<Vec3f>(*target.layout, target.frame_mesh(), displacement()).value();
  }

  /// What the guest shows, in the sample's order.
  static FrameSample shown(LiveGuest& guest) {
    const FrameLayout& layout = *guest.subscriber().target->layout;
    FrameSample seen;
    seen.steps.resize(size_t{3} * layout.value_count());
    for (int tile = 0; tile < layout.tile_count(); ++tile)
      guest.decoder.state().read_tile(tile,
                                      {seen.steps.data() + size_t{3} * layout.tile_begin(tile),
                                       size_t{3} * layout.tile_size(tile)});
    return seen;
  }

  Stroke stroke() const { return {{0.4, 0.7, 0.2, FallOff::kSmooth}, {{1, 0, 0}, {0, 1, 0}}}; }

  TestLibrary library_;
  std::unique_ptr<Journal> journal_;
  std::unique_ptr<SessionManager> manager_;
  std::unique_ptr<LiveSessions> live_;
};

TEST_F(LiveSessionTest, SettledEveryClientHoldsTheRoundedDisplacement) {
  auto whole = guest(), proxy = guest("bob", {"work", 200}),
       vertices = guest("eve", {"work", 0, FrameContent::kVertices});
  whole.edit({{"a", stroke()}, {"b", SetTransferCurve{TransferCurve(20)}}});
  for (LiveGuest* each : {&whole, &proxy, &vertices}) each->settle();
  for (LiveGuest* each : {&whole, &proxy, &vertices})
    EXPECT_EQ(shown(*each).steps, sample(*each).steps);
}

TEST_F(LiveSessionTest, WhileItMovesAFrameIsOffByAtMostTheCodecsStep) {
  auto ann = guest("ann", {"work", 0, FrameContent::kVertices});
  ann.edit({{"a", SetGradientScale{0}}});
  ann.subscriber().grant({.frames = 1});
  ASSERT_TRUE(live_->scheduler().run_one());
  const FrameSample exact = sample(ann);
  while (ann.decoded.empty()) ann.run();
  ASSERT_EQ(ann.all<LiveFrame>().size(), 1u);
  EXPECT_FALSE(ann.all<LiveFrame>()[0].facts.settled);
  const FrameSample seen = shown(ann);
  for (size_t i = 0; i < exact.steps.size(); ++i)
    ASSERT_LE(std::abs(exact.steps[i] - seen.steps[i]), 2);  // half of 1/64 cell
}

TEST_F(LiveSessionTest, OverASlowLinkASettledSurfaceIsShownInPartsAndExactInTheEnd) {
  ASSERT_TRUE(library_.import(sphere_file(1, 5), "large").is_ok());
  ASSERT_TRUE(manager_->open({"large", "large", {5, 0}}, "ann", {}).is_ok());
  const LiveGreeting wish{"large", 0, FrameContent::kVertices};  // of several tiles
  auto ann = guest("ann", wish), bob = guest("bob", wish);
  ann.edit({{"a", SetGradientScale{0}}});
  bob.settle();
  size_t parts = 0;
  for (;; ++parts) {
    ann.run();
    const auto frames = ann.all<LiveFrame>();
    if (!frames.empty() && frames.back().facts.settled && ann.decoded.empty()) break;
    ASSERT_LT(parts, 100u);
    ann.subscriber().grant(
        {.frames = 1, .decoded = std::exchange(ann.decoded, {}), .frame_bytes = 1000});
  }
  EXPECT_EQ(shown(ann).steps, shown(bob).steps);
  EXPECT_GE(parts, 4u);
}

TEST_F(LiveSessionTest, WithoutAnAcknowledgementOneKeyFrameGoesOut) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0}}});
  ann.subscriber().grant({.frames = 8});
  ann.run();
  EXPECT_EQ(ann.all<LiveFrame>().size(), 1u);
  ann.subscriber().grant({.decoded = ann.decoded});
  ann.run();
  EXPECT_GT(ann.all<LiveFrame>().size(), 1u);
}

TEST_F(LiveSessionTest, NoFrameGoesOutWithoutACredit) {
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

TEST_F(LiveSessionTest, SettledItIsSilentUntilSomethingChanges) {
  auto ann = guest();
  ann.settle();
  ann.subscriber().grant({.frames = 8});
  ann.run();
  const size_t frames = ann.all<LiveFrame>().size();
  const int cycles = ann.all<LiveFrame>().back().facts.report.cycle;
  for (int i = 0; i < 3; ++i) ann.run();
  EXPECT_EQ(ann.all<LiveFrame>().size(), frames);
  EXPECT_EQ(live_->scheduler().waiting(), 0u);
  ann.edit({{"a", SetGradientScale{0.5}}});
  ann.settle();
  EXPECT_GT(ann.all<LiveFrame>().back().facts.report.cycle, cycles);
  EXPECT_EQ(ann.all<LiveFrame>().back().facts.edits, 1u);
}

TEST_F(LiveSessionTest, WhatAnExactExportRelaxedIsShownAsExact) {
  auto ann = guest();
  ann.edit({{"a", stroke()}});  // a slider alone may be exact at once
  ann.settle();
  EXPECT_FALSE(ann.all<LiveFrame>().back().facts.exact);
  ASSERT_TRUE(
      manager_->export_mesh("work", {.format = MeshFormat::kPly, .exact = true}, {}).is_ok());
  ann.settle();
  EXPECT_TRUE(ann.all<LiveFrame>().back().facts.exact);
  EXPECT_EQ(shown(ann).steps, sample(ann).steps);
  ann.edit({{"b", stroke()}});
  ann.settle();
  EXPECT_FALSE(ann.all<LiveFrame>().back().facts.exact);
}

TEST_F(LiveSessionTest, WhoComesToASettledSurfaceGetsOneStillFrameWithoutACycle) {
  auto ann = guest();
  ann.settle();
  const int cycles = ann.all<LiveFrame>().back().facts.report.cycle;
  auto bob = guest("bob");
  bob.settle();
  ASSERT_EQ(bob.all<LiveFrame>().size(), 1u);
  EXPECT_EQ(bob.all<LiveFrame>()[0].facts.report.cycle, cycles);
  EXPECT_EQ(shown(bob).steps, sample(bob).steps);
}

TEST_F(LiveSessionTest, AFrameThatCouldNotBeDecodedIsMadeUpFor) {
  auto ann = guest();
  ann.settle();
  ann.decoder = FrameDecoder(ann.subscriber().target->layout);  // it has lost everything
  ann.subscriber().grant({.frames = 1, .key_frame = true});
  ann.run();
  EXPECT_EQ(shown(ann).steps, sample(ann).steps);
}

TEST_F(LiveSessionTest, EditsAreAnsweredOnceOnDiskAllOrNone) {
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
  EXPECT_EQ(ann.all<HistoryState>().back(), (HistoryState{2, 0.5, TransferCurve(50)}));
}

TEST_F(LiveSessionTest, APreviewReachesEverybodyAndIsGoneWithItsConnection) {
  auto ann = guest(), bob = guest("bob");
  bob.settle();
  const FrameSample before = shown(bob);
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", stroke()}).is_ok());
  bob.subscriber().grant({.frames = 1});
  bob.settle();
  EXPECT_NE(shown(bob).steps, before.steps);
  EXPECT_EQ(bob.all<LiveFrame>().back().facts.edits, 0u);
  ann.leave();
  bob.subscriber().grant({.frames = 1});
  bob.settle();
  int worst = 0;
  for (size_t i = 0; i < before.steps.size(); ++i)
    worst = std::max(worst, std::abs(before.steps[i] - shown(bob).steps[i]));
  EXPECT_LE(worst, 1);
  EXPECT_EQ(manager_->list()[0].edits, 0u);
}

TEST_F(LiveSessionTest, APreviewGivesWayToItsEditAndFramesCountIt) {
  auto ann = guest();
  ann.settle();
  ASSERT_TRUE(ann.session().preview(ann.connection(), {"drag", SetGradientScale{0.5}}).is_ok());
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().facts.previews, 1u);
  const FrameSample dragged = shown(ann);
  ann.edit({{"drag", SetGradientScale{0.5}}});
  ann.subscriber().grant({.frames = 1});
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().facts.edits, 1u);
  EXPECT_EQ(shown(ann).steps, dragged.steps);
}

TEST_F(LiveSessionTest, AnExportLeavesPreviewsOut) {
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
  EXPECT_NE(ann.all<LiveFrame>().back().facts.report.energy, energy);
}

TEST_F(LiveSessionTest, ACancelledExportLeavesNothingUnsolved) {
  ASSERT_TRUE(manager_->apply("work", "ann", std::vector<Edit>{{"a", stroke()}}, {}).is_ok());
  int reports = 0;
  const auto cancelled_at_once = [&](std::string_view, double) { return ++reports < 2; };
  EXPECT_FALSE(manager_->export_mesh("work", {}, cancelled_at_once).is_ok());
  auto ann = guest();
  ann.settle();
  EXPECT_GT(ann.all<LiveFrame>().back().facts.report.cycle, 2);
  EXPECT_LT(ann.all<LiveFrame>().back().facts.report.distance, 1e-4);
}

TEST_F(LiveSessionTest, PreviewsAreCheckedAsAWhole) {
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
  EXPECT_THAT(grow(fine).message(), HasSubstr("brush of preview drag is another"));
}

TEST_F(LiveSessionTest, AViewerNeitherEditsNorPreviews) {
  ASSERT_TRUE(manager_->set_role("work", "ann", "bob", SessionRole::kViewer, {}).is_ok());
  auto bob = guest("bob");
  EXPECT_EQ(bob.role, SessionRole::kViewer);
  bob.edit({{"a", SetGradientScale{0.5}}});
  bob.run();
  EXPECT_EQ(bob.all<EditsRefused>()[0].status.code(), StatusCode::kPermissionDenied);
  const Status preview = bob.session().preview(bob.connection(), {"b", SetGradientScale{0.5}});
  EXPECT_EQ(preview.code(), StatusCode::kPermissionDenied);
}

TEST_F(LiveSessionTest, ARoleThatChangesIsToldAndCounts) {
  auto ann = guest(), bob = guest("bob");
  ann.run();
  ASSERT_TRUE(manager_->set_role("work", "ann", "bob", SessionRole::kViewer, {}).is_ok());
  ann.run();
  bob.run();
  EXPECT_EQ(bob.all<SessionPeople>().back().roles.of("bob"), SessionRole::kViewer);
  EXPECT_FALSE(bob.session().preview(bob.connection(), {"b", SetGradientScale{1}}).is_ok());
}

TEST_F(LiveSessionTest, SomebodyElseAtTheSessionHoldsUpOnlyItsOwnTurns) {
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

TEST_F(LiveSessionTest, ClosedAndDeletedSessionsSendTheirClientsAway) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0.5}}});
  ASSERT_TRUE(manager_->close("work", "ann", {}).is_ok());
  ann.run();
  // What had come before is answered all the same.
  EXPECT_EQ(ann.all<EditsAcknowledged>().size(), 1u);
  EXPECT_EQ(ann.all<Farewell>()[0].reason, "the session was closed by ann");
  EXPECT_FALSE(ann.all<Farewell>()[0].come_back);
  EXPECT_TRUE(ann.finished);
  auto again = guest();  // while the first one is still on the way out
  ann.leave();
  again.edit({{"b", SetGradientScale{0.25}}});
  again.run();
  EXPECT_EQ(again.all<EditsAcknowledged>().size(), 1u);
  again.edit({{"c", SetGradientScale{0.75}}});
  ASSERT_TRUE(manager_->remove("work", "ann", {}).is_ok());
  again.run();
  EXPECT_EQ(again.all<EditsRefused>().size(), 1u);
  EXPECT_FALSE(again.all<Farewell>()[0].come_back);
  EXPECT_TRUE(again.finished);
}

TEST_F(LiveSessionTest, AClosedSessionStaysOutOfMemoryWhileItsClientsGo) {
  auto ann = guest(), bob = guest("bob");
  ann.edit({{"a", SetGradientScale{0}}});
  bob.run();
  ASSERT_TRUE(manager_->close("work", "ann", {}).is_ok());
  ann.leave();
  bob.run();
  EXPECT_TRUE(bob.finished);
  EXPECT_FALSE(manager_->list()[0].in_memory);
}

TEST_F(LiveSessionTest, WhatClientsDrawIsAdmittedByItsBytes) {
  Quota& memory = manager_->memory();
  const uint64_t before = memory.taken();
  {
    const Quota::Share others = memory.take("others", memory.max() - 1000).value();
    const Quota::Share own = memory.take(kServer, memory.max() - before - 1000).value();
    const Status refused = live_->join({"work", 100}, "ann", {}, {}).status();
    EXPECT_EQ(refused.code(), StatusCode::kResourceExhausted);
    EXPECT_THAT(refused.message(), testing::ContainsRegex("asks for [0-9]+ more"));
  }
  uint64_t whole = 0;
  {
    auto ann = guest(), bob = guest("bob");
    whole = memory.taken() - before;
    EXPECT_GE(whole, ann.subscriber().target->layout->byte_count());
    const auto proxy = guest("eve", {"work", 100});
    EXPECT_GT(memory.taken(), before + whole);
  }
  EXPECT_EQ(memory.taken(), before);
}

TEST_F(LiveSessionTest, ADrainingServerLetsNobodyIn) {
  auto ann = guest();
  live_->drain();
  ann.run();
  EXPECT_TRUE(ann.all<Farewell>()[0].come_back);
  ann.edit({{"late", SetGradientScale{0.5}}});
  ann.run();
  EXPECT_TRUE(ann.all<EditsAcknowledged>().empty());
  EXPECT_EQ(live_->join({"work"}, "bob", {}, {}).status().code(), StatusCode::kUnavailable);
}

TEST_F(LiveSessionTest, WhoIsSilentIsSentAwayAndWatchersMayBe) {
  auto ann = guest(), eve = guest("eve", {"work", 0, {}, true});
  ann.run();
  ann.session().end_silent(std::chrono::hours(1));
  ann.run();
  EXPECT_FALSE(ann.finished);
  ann.session().end_silent(std::chrono::seconds(0));
  ann.run();
  eve.run();
  ASSERT_EQ(ann.all<Farewell>().size(), 1u);
  EXPECT_TRUE(ann.finished);
  EXPECT_TRUE(eve.all<Farewell>().empty());
}

TEST_F(LiveSessionTest, WhoDoesNotTakeItsAnswersIsNotReadOn) {
  auto ann = guest();
  EXPECT_TRUE(ann.subscriber().may_send());
  for (int i = 0; i < 64; ++i) ann.edit({{"e" + std::to_string(i), SetGradientScale{0.5}}});
  EXPECT_FALSE(ann.subscriber().may_send());
  ann.run();
  EXPECT_TRUE(ann.subscriber().may_send());
}

TEST_F(LiveSessionTest, UnusedSessionsLeaveMemoryAndComeBackAsTheyWere) {
  {
    auto ann = guest();
    ann.edit({{"a", stroke()}});
    ann.run();
    manager_->spill_idle(std::chrono::seconds(0));
    EXPECT_TRUE(manager_->list()[0].in_memory);  // somebody is there
  }
  manager_->spill_idle(std::chrono::seconds(1000));
  EXPECT_TRUE(manager_->list()[0].in_memory);
  manager_->spill_idle(std::chrono::seconds(0));
  EXPECT_FALSE(manager_->list()[0].in_memory);
  EXPECT_EQ(manager_->usage().session_bytes, 0u);
  auto ann = guest();
  ann.settle();
  EXPECT_EQ(ann.all<LiveFrame>().back().facts.edits, 1u);
  EXPECT_EQ(shown(ann).steps, sample(ann).steps);
}

TEST_F(LiveSessionTest, OfPeopleOnlyTheNewestIsKept) {
  auto ann = guest(), bob = guest("bob");
  ann.run();
  ann.received.clear();
  for (int i = 1; i <= 100; ++i)
    bob.session().move_brush(bob.connection(), BrushRing{{0, 0, 0}, 0.01 * i});
  ann.run();
  const auto people = ann.all<SessionPeople>();
  ASSERT_EQ(people.size(), 1u);
  EXPECT_EQ(people[0].present[1].ring->radius, 1);
}

}  // namespace
}  // namespace burnish
