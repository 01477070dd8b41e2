// The people in a live session: their roles, and how they are sent away.

#include <gtest/gtest.h>

#include "tests/server/live/live_work.h"

namespace burnish {
namespace {

using LivePeople = LiveWork;

TEST_F(LivePeople, AViewerNeitherEditsNorPreviews) {
  ASSERT_TRUE(manager_->set_role("work", "ann", "bob", SessionRole::kViewer, {}).is_ok());
  auto bob = guest("bob");
  EXPECT_EQ(bob.welcome.role, SessionRole::kViewer);
  bob.edit({{"a", SetGradientScale{0.5}}});
  bob.run();
  EXPECT_EQ(bob.all<EditsRefused>()[0].status.code(), StatusCode::kPermissionDenied);
  const Status preview = bob.session().preview(bob.connection(), {"b", SetGradientScale{0.5}});
  EXPECT_EQ(preview.code(), StatusCode::kPermissionDenied);
}

TEST_F(LivePeople, ARoleThatChangesIsToldAndCounts) {
  auto ann = guest(), bob = guest("bob");
  ann.run();
  ASSERT_TRUE(manager_->set_role("work", "ann", "bob", SessionRole::kViewer, {}).is_ok());
  ann.run();
  bob.run();
  EXPECT_EQ(bob.all<SessionPeople>().back().roles.of("bob"), SessionRole::kViewer);
  EXPECT_FALSE(bob.session().preview(bob.connection(), {"b", SetGradientScale{1}}).is_ok());
}

TEST_F(LivePeople, OfPeopleOnlyTheNewestIsKept) {
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

TEST_F(LivePeople, ClosedAndDeletedSessionsSendTheirClientsAway) {
  auto ann = guest();
  ann.edit({{"a", SetGradientScale{0.5}}});
  ASSERT_TRUE(manager_->close("work", "ann", {}).is_ok());
  ann.run();
  // Earlier edits are still answered.
  EXPECT_EQ(ann.all<EditsAcknowledged>().size(), 1u);
  EXPECT_EQ(ann.all<GoAway>()[0].reason, "the session was closed by ann");
  EXPECT_EQ(ann.all<GoAway>()[0].code, GoAwayCode::kClosed);
  EXPECT_FALSE(ann.all<GoAway>()[0].come_back);
  EXPECT_TRUE(ann.finished);
  auto again = guest();  // while the first is still leaving
  ann.leave();
  again.edit({{"b", SetGradientScale{0.25}}});
  again.run();
  EXPECT_EQ(again.all<EditsAcknowledged>().size(), 1u);
  again.edit({{"c", SetGradientScale{0.75}}});
  ASSERT_TRUE(manager_->remove("work", "ann", {}).is_ok());
  again.run();
  EXPECT_EQ(again.all<EditsRefused>().size(), 1u);
  EXPECT_FALSE(again.all<GoAway>()[0].come_back);
  EXPECT_TRUE(again.finished);
}

TEST_F(LivePeople, ADrainingServerLetsNobodyIn) {
  auto ann = guest();
  live_->drain();
  ann.run();
  EXPECT_EQ(ann.all<GoAway>()[0].code, GoAwayCode::kGoingDown);
  EXPECT_TRUE(ann.all<GoAway>()[0].come_back);
  ann.edit({{"late", SetGradientScale{0.5}}});
  ann.run();
  EXPECT_TRUE(ann.all<EditsAcknowledged>().empty());
  EXPECT_EQ(live_->join({"work"}, "bob", {}, {}).status().code(), StatusCode::kUnavailable);
}

TEST_F(LivePeople, ADrainingServerNamesTheOneThatTakesTheSession) {
  auto ann = guest(), bob = guest("bob");
  live_->drain(Successors({{{"two:7411", "two"}, 1}, {{"three:7411", "three"}, 2}}));
  for (LiveGuest* one : {&ann, &bob}) {
    one->run();
    EXPECT_EQ(one->all<GoAway>()[0].moved_to, (ServerPlace{"three:7411", "three"}));
  }
}

TEST_F(LivePeople, ASessionThatHasMovedIsLeftAtOnceAndItsEditsGetNoAnswer) {
  auto ann = guest();
  ASSERT_TRUE(ann.subscriber().expect_answer(1));  // the journal waits for its database
  ann.edit({{"a", SetGradientScale{0.5}}});
  live_->set_fleet({"one:7411", "two:7411"});
  live_->on_session_moved(ann.welcome.session.id, Status::moved("two@two:7411", "two has it"));
  ann.run();
  ASSERT_EQ(ann.all<GoAway>().size(), 1u);
  EXPECT_EQ(ann.all<GoAway>()[0].code, GoAwayCode::kNotOwner);
  EXPECT_TRUE(ann.all<GoAway>()[0].come_back);
  EXPECT_EQ(ann.all<GoAway>()[0].moved_to, (ServerPlace{"two:7411", "two"}));
  EXPECT_EQ(ann.all<GoAway>()[0].fleet, (std::vector<std::string>{"one:7411", "two:7411"}));
  EXPECT_TRUE(ann.finished);
  ann.subscriber().acknowledge({{"b"}, {}}, 1);
  ann.run();
  EXPECT_TRUE(ann.all<EditsAcknowledged>().empty());
  EXPECT_TRUE(ann.all<EditsRefused>().empty());
}

TEST_F(LivePeople, AGoAwayThatWaitsForAnswersGoesOutWhenTheSessionMoves) {
  auto ann = guest();
  ASSERT_TRUE(ann.subscriber().expect_answer(1));
  live_->drain();
  ann.run();
  EXPECT_TRUE(ann.all<GoAway>().empty());
  live_->on_session_moved(ann.welcome.session.id, unavailable("the lease is over"));
  ann.run();
  EXPECT_EQ(ann.all<GoAway>().size(), 1u);
  EXPECT_TRUE(ann.finished);
}

TEST(Successors, EachSessionGoesWhereTheMostMemoryIsLeft) {
  Successors successors({{{"two:7411", "two"}, 10}, {{"", "three"}, 12}});
  EXPECT_EQ(successors.next(5)->node, "three");
  EXPECT_EQ(successors.next(20)->node, "two");
  EXPECT_EQ(successors.next(20)->node, "three");
  EXPECT_TRUE(successors.next(1)) << "one without room names another one itself";
  EXPECT_FALSE(Successors().next(1));
}

TEST_F(LivePeople, WhoIsSilentIsSentAwayAndWatchersMayBe) {
  auto ann = guest();
  auto eve = LiveGuest(*live_, *library_.store, {"work"}, "eve", {.may_be_silent = true});
  ann.run();
  ann.session().end_unwelcome(std::chrono::hours(1));
  ann.run();
  EXPECT_FALSE(ann.finished);
  ann.session().end_unwelcome(std::chrono::seconds(0));
  ann.run();
  eve.run();
  ASSERT_EQ(ann.all<GoAway>().size(), 1u);
  EXPECT_EQ(ann.all<GoAway>()[0].code, GoAwayCode::kSilent);
  EXPECT_TRUE(ann.finished);
  EXPECT_TRUE(eve.all<GoAway>().empty());
}

TEST_F(LivePeople, AViewerOfTheServerIsOneInEverySession) {
  Caller vera("vera");
  vera.most = SessionRole::kViewer;
  auto guest = LiveGuest(*live_, *library_.store, {"work"}, vera);
  EXPECT_EQ(guest.welcome.role, SessionRole::kViewer);
  guest.edit({{"a", SetGradientScale{0}}});
  guest.run();
  ASSERT_EQ(guest.all<EditsRefused>().size(), 1u);
  EXPECT_EQ(guest.all<EditsRefused>()[0].status.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(guest.session().preview(guest.connection(), {"drag", SetGradientScale{0}}).code(),
            StatusCode::kPermissionDenied);
  EXPECT_EQ(manager_->list()[0].edits, 0u);
}

TEST_F(LivePeople, WhoMayNotStayIsSentAwayForGood) {
  Status stays;
  auto eve = LiveGuest(*live_, *library_.store, {"work"}, "eve",
                       {.may_be_silent = true, .may_stay = [&] { return stays; }});
  eve.run();
  eve.session().end_unwelcome(std::chrono::hours(1));
  eve.run();
  EXPECT_FALSE(eve.finished);
  stays = {StatusCode::kPermissionDenied, "eve has left"};
  eve.session().end_unwelcome(std::chrono::hours(1));
  eve.run();
  ASSERT_EQ(eve.all<GoAway>().size(), 1u);
  EXPECT_EQ(eve.all<GoAway>()[0].code, GoAwayCode::kRemoved);
  EXPECT_EQ(eve.all<GoAway>()[0].reason, "eve has left");
  EXPECT_FALSE(eve.all<GoAway>()[0].come_back);
  EXPECT_TRUE(eve.finished);
}

TEST_F(LivePeople, WhoDoesNotTakeItsAnswersIsNotReadOn) {
  auto ann = guest();
  EXPECT_TRUE(ann.subscriber().may_send());
  for (int i = 0; i < 64; ++i) ann.edit({{"e" + std::to_string(i), SetGradientScale{0.5}}});
  EXPECT_FALSE(ann.subscriber().may_send());
  ann.run();
  EXPECT_TRUE(ann.subscriber().may_send());
}

}  // namespace
}  // namespace burnish
