#include "client/live/live_conversation.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/live/small_surface.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

/// A conversation with a server of one's own, at a time of one's own.
class Conversations : public testing::Test {
 protected:
  static LiveOptions options(Clock clock) {
    LiveOptions options;
    options.greeting.session = "work";
    options.head = small_head();
    options.depth = small_depth();
    options.pages_fingerprint = 5;
    options.clock = std::move(clock);
    return options;
  }
  static Welcome welcome(uint64_t fingerprint = 5) {
    Welcome welcome;
    welcome.session.name = "work";
    welcome.session.key.depth = small_depth();
    welcome.pages_fingerprint = fingerprint;
    return welcome;
  }
  static std::vector<Edit> slider(const std::string& id) {
    return {Edit{id, SetGradientScale{0.5}}};
  }

  bool hear(ServerMessage message) { return talk_.hear(std::optional(std::move(message))); }

  /// Returns all that is said now.
  std::vector<ClientMessage> say() {
    std::vector<ClientMessage> said;
    while (auto message = talk_.next()) said.push_back(std::move(*message));
    return said;
  }
  template <typename Message>
  static std::vector<Message> of_kind(const std::vector<ClientMessage>& said) {
    std::vector<Message> found;
    for (const ClientMessage& message : said)
      if (const auto* one = std::get_if<Message>(&message)) found.push_back(*one);
    return found;
  }
  template <typename Event>
  static std::vector<Event> told(const LiveNews& news) {
    std::vector<Event> found;
    for (const LiveEvent& event : news.events)
      if (const auto* one = std::get_if<Event>(&event)) found.push_back(*one);
    return found;
  }

  LiveConversation::Time now_{seconds(100)};
  std::shared_ptr<ServerRoute> route_ = std::make_shared<ServerRoute>("scanner:7411");
  LiveConversation talk_{route_, options([this] { return now_; })};
};

TEST_F(Conversations, BeginWithTheGreeting) {
  talk_.begin();
  const auto said = say();
  ASSERT_FALSE(said.empty());
  ASSERT_TRUE(std::holds_alternative<Greeting>(said.front()));
  EXPECT_EQ(std::get<Greeting>(said.front()).session, "work");
}

TEST_F(Conversations, AreLiveFromTheWelcomeOn) {
  talk_.begin();
  EXPECT_EQ(talk_.take().link, LinkState::kConnecting);
  hear(welcome());
  const LiveNews news = talk_.take();
  EXPECT_EQ(news.link, LinkState::kLive);
  ASSERT_EQ(told<Welcome>(news).size(), 1u);
  EXPECT_EQ(told<Welcome>(news)[0].session.name, "work");
}

TEST_F(Conversations, AWelcomeOfOtherPagesEndsTheSession) {
  talk_.begin();
  hear(welcome(6));
  EXPECT_TRUE(talk_.must_leave());
  EXPECT_FALSE(talk_.end(Status::ok()));
  EXPECT_TRUE(talk_.has_ended());
  EXPECT_EQ(talk_.apply(slider("late")).code(), StatusCode::kFailedPrecondition);
}

TEST_F(Conversations, AMessageThatDoesNotParseEndsTheStream) {
  talk_.begin();
  talk_.hear(invalid_argument("a frame of 3 bytes"));
  EXPECT_TRUE(talk_.must_leave());
  EXPECT_FALSE(talk_.end(Status::ok()));
  EXPECT_THAT(told<LinkChanged>(talk_.take()).back().reason, HasSubstr("a frame of 3 bytes"));
}

TEST_F(Conversations, AMessageOfANewerServerIsPassedOver) {
  talk_.begin();
  hear(welcome());
  talk_.hear(std::optional<ServerMessage>());
  EXPECT_FALSE(talk_.must_leave());
  EXPECT_EQ(talk_.take().link, LinkState::kLive);
}

TEST_F(Conversations, SayUnansweredEditsAgainOnTheNextStream) {
  talk_.begin();
  ASSERT_TRUE(talk_.apply(slider("one")).is_ok());
  ASSERT_EQ(of_kind<ApplyEdits>(say()).size(), 1u);
  EXPECT_EQ(of_kind<ApplyEdits>(say()).size(), 0u);
  EXPECT_TRUE(talk_.end(unavailable("the connection is lost")));
  EXPECT_EQ(talk_.unacknowledged(), 1u);
  talk_.begin();
  const auto said = of_kind<ApplyEdits>(say());
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].edits[0].id, "one");
  hear(EditsAcknowledged{{"one"}, {}});
  EXPECT_EQ(talk_.unacknowledged(), 0u);
}

TEST_F(Conversations, EditsThatCannotBeKeptNowWaitForAnotherStream) {
  talk_.begin();
  hear(welcome());
  ASSERT_TRUE(talk_.apply(slider("one")).is_ok());
  say();
  hear(EditsRefused{{"one"}, unavailable("the disk is full")});
  EXPECT_TRUE(talk_.must_leave());
  EXPECT_TRUE(talk_.end(Status::ok()));
  EXPECT_EQ(talk_.unacknowledged(), 1u);
  EXPECT_THAT(told<LinkChanged>(talk_.take()).back().reason,
              HasSubstr("scanner:7411: the disk is full"));
}

TEST_F(Conversations, ARefusedEditIsForgottenAndTold) {
  talk_.begin();
  hear(welcome());
  ASSERT_TRUE(talk_.apply(slider("one")).is_ok());
  say();
  hear(EditsRefused{{"one"}, invalid_argument("beta 99")});
  EXPECT_FALSE(talk_.must_leave());
  EXPECT_EQ(talk_.unacknowledged(), 0u);
  EXPECT_EQ(told<EditsRefused>(talk_.take()).size(), 1u);
}

TEST_F(Conversations, ASilentServerIsLeft) {
  talk_.begin();
  hear(welcome());
  now_ += seconds(14);
  EXPECT_FALSE(talk_.must_leave());
  now_ += seconds(1);
  EXPECT_TRUE(talk_.must_leave());
  EXPECT_TRUE(talk_.end(Status::ok()));
  const LiveNews news = talk_.take();
  EXPECT_EQ(news.link, LinkState::kLost);
  EXPECT_THAT(told<LinkChanged>(news).back().reason, HasSubstr("nothing was heard for 15 s"));
}

TEST_F(Conversations, ALinkThatIsBackBeforeTheNextPictureIsToldAsLostAndLive) {
  const auto states = [this] {
    std::vector<LinkState> found;
    for (const LinkChanged& change : told<LinkChanged>(talk_.take())) found.push_back(change.state);
    return found;
  };
  talk_.begin();
  hear(welcome());
  EXPECT_THAT(states(), ElementsAre(LinkState::kLive));
  for (int i = 0; i < 3; ++i) {  // who does not listen for a while learns of one loss
    EXPECT_TRUE(talk_.end(unavailable("the connection is lost")));
    talk_.begin();
    hear(welcome());
  }
  EXPECT_THAT(states(), ElementsAre(LinkState::kLost, LinkState::kLive));
}

TEST_F(Conversations, AHeartbeatIsDueAtItsDeadlineAndNotBefore) {
  talk_.begin();
  hear(welcome());
  say();
  const auto due = talk_.next_deadline();
  EXPECT_LE(due, now_ + seconds(1));
  now_ = due - milliseconds(1);
  EXPECT_EQ(of_kind<Heartbeat>(say()).size(), 0u);
  now_ += seconds(1);
  EXPECT_EQ(of_kind<Heartbeat>(say()).size(), 1u);
}

TEST_F(Conversations, AnEchoedHeartbeatTellsTheRoundTrip) {
  talk_.begin();
  hear(welcome());
  const auto beats = of_kind<Heartbeat>(say());
  ASSERT_FALSE(beats.empty());
  now_ += milliseconds(30);
  EXPECT_FALSE(hear(beats.back())) << "it is worth no picture";
  EXPECT_DOUBLE_EQ(talk_.take().stats.rtt_ms, 30);
}

TEST_F(Conversations, AllButEchoesAreWorthAPicture) {
  talk_.begin();
  EXPECT_TRUE(hear(welcome()));
  EXPECT_TRUE(hear(ProgressReport{}));
  EXPECT_TRUE(talk_.hear(invalid_argument("a frame of 3 bytes")));
}

TEST_F(Conversations, TheWaitForAnotherStreamGrowsUpToItsLimit) {
  milliseconds longest{0};
  for (int i = 0; i < 12; ++i) {
    talk_.begin();
    const auto wait = talk_.end(unavailable("nobody answers"));
    ASSERT_TRUE(wait);
    if (i == 0) {
      EXPECT_LE(*wait, milliseconds(100));
    }
    longest = std::max(longest, *wait);
  }
  EXPECT_GE(longest, milliseconds(1500));
  EXPECT_LE(longest, milliseconds(3000));
}

TEST_F(Conversations, AGoAwaySaysWhetherToComeBack) {
  talk_.begin();
  hear(welcome());
  hear(GoAway{GoAwayCode::kGoingDown, "the server ends", true});
  EXPECT_TRUE(talk_.must_leave());
  EXPECT_TRUE(talk_.end(Status::ok()));
  talk_.begin();
  hear(welcome());
  hear(GoAway{GoAwayCode::kClosed, "the session was deleted", false});
  EXPECT_TRUE(talk_.must_leave());
  EXPECT_FALSE(talk_.end(Status::ok()));
  EXPECT_EQ(talk_.take().link, LinkState::kEnded);
}

TEST_F(Conversations, FollowAMovedSessionAtOnceAndKeepItsEdits) {
  ASSERT_TRUE(talk_.apply(slider("one")).is_ok());
  talk_.begin();
  say();
  const auto wait = talk_.end(Status::moved("two@two:7411", "server two holds the session"));
  ASSERT_TRUE(wait);
  EXPECT_EQ(*wait, milliseconds(0));
  EXPECT_EQ(route_->place(), (ServerPlace{"two:7411", "two"}));
  talk_.begin();
  EXPECT_EQ(of_kind<ApplyEdits>(say()).size(), 1u);
  EXPECT_FALSE(talk_.has_ended());
}

TEST_F(Conversations, ASessionThatMovesInACircleIsWaitedFor) {
  for (int i = 0; i < kMovesMax; ++i) {
    talk_.begin();
    EXPECT_EQ(*talk_.end(Status::moved("two@two:7411", "moved")), milliseconds(0)) << i;
  }
  talk_.begin();
  EXPECT_GT(*talk_.end(Status::moved("two@two:7411", "moved")), milliseconds(0));
}

TEST_F(Conversations, AnotherServerOfTheFleetIsTriedWhenOneIsGone) {
  talk_.begin();
  Welcome greeted = welcome();
  greeted.fleet = {"scanner:7411", "two:7411"};
  hear(greeted);
  EXPECT_TRUE(talk_.end(unavailable("the connection is lost")));
  EXPECT_EQ(route_->address(), "scanner:7411") << "it may be back at once";
  EXPECT_TRUE(talk_.end(unavailable("nobody answers")));
  EXPECT_EQ(route_->address(), "two:7411");
}

TEST_F(Conversations, AServerWithoutTheSessionIsLeftForAnotherOfTheFleet) {
  Welcome greeted = welcome();
  greeted.fleet = {"scanner:7411", "two:7411"};
  const char* next = "two:7411";
  for (const auto code : {GoAwayCode::kGoingDown, GoAwayCode::kNotOwner}) {
    talk_.begin();
    hear(greeted);
    hear(GoAway{code, "the server ends", true});
    EXPECT_TRUE(talk_.end(Status::ok()));
    EXPECT_EQ(route_->address(), std::exchange(next, "scanner:7411"));
  }
  talk_.begin();
  hear(greeted);
  hear(GoAway{GoAwayCode::kNotOwner, "no database", true, std::nullopt, {"three:7411"}});
  EXPECT_TRUE(talk_.end(Status::ok()));
  EXPECT_EQ(route_->address(), "three:7411") << "it has joined the fleet since";
}

TEST_F(Conversations, AGoAwayThatNamesAnotherServerLeadsThereAtOnceWithTheEdits) {
  talk_.begin();
  hear(welcome());
  ASSERT_TRUE(talk_.apply(slider("one")).is_ok());
  say();
  hear(GoAway{GoAwayCode::kGoingDown, "the server ends", true, ServerPlace{"three:7411", "three"}});
  EXPECT_TRUE(talk_.must_leave());
  const auto wait = talk_.end(Status::ok());
  ASSERT_TRUE(wait);
  EXPECT_EQ(*wait, milliseconds(0));
  EXPECT_EQ(route_->place(), (ServerPlace{"three:7411", "three"}));
  talk_.begin();
  EXPECT_EQ(of_kind<ApplyEdits>(say()).size(), 1u);
}

TEST_F(Conversations, NoMemoryForThePagesIsCounted) {
  talk_.begin();
  hear(welcome());
  EXPECT_TRUE(talk_.end({StatusCode::kResourceExhausted, "no memory for 3 pages"}));
  EXPECT_EQ(talk_.take().pages_refused, 1u);
}

TEST_F(Conversations, OnlyAPictureAsksForAnotherFrame) {
  talk_.begin();
  hear(welcome());
  const auto credits = [this] {
    uint32_t frames = 0;
    for (const FrameCredit& credit : of_kind<FrameCredit>(say())) frames += credit.frames;
    return frames;
  };
  EXPECT_EQ(credits(), 1u);
  hear(LiveFrame{});  // nothing has moved
  talk_.take(false);
  now_ += seconds(1);
  EXPECT_EQ(credits(), 0u);
  talk_.take();
  EXPECT_EQ(credits(), 1u);
}

TEST_F(Conversations, NewsSayWhetherAFrameHasSeenAllPreviewsAndTheirEnds) {
  const auto frame_after = [this](uint64_t previews) {
    LiveFrame frame;
    frame.stats.previews = previews;
    hear(frame);
    return talk_.take().shows_previews;
  };
  talk_.begin();
  hear(welcome());
  EXPECT_TRUE(talk_.take().shows_previews) << "there is none";
  talk_.preview("one", SetGradientScale{0.5});
  EXPECT_FALSE(talk_.take().shows_previews) << "it is not said";
  say();
  EXPECT_FALSE(frame_after(0)) << "the frame is older";
  EXPECT_TRUE(frame_after(1));
  talk_.drop_preview("one");
  EXPECT_FALSE(talk_.take().shows_previews);
  say();
  EXPECT_FALSE(frame_after(1)) << "the frame still has it";
  EXPECT_TRUE(frame_after(2));
}

TEST_F(Conversations, MessagesThatReplaceEachOtherAreToldOnce) {
  talk_.begin();
  hear(welcome());
  hear(ProgressReport{"reading", 0.1});
  hear(ProgressReport{"reading", 0.9});
  const auto reports = told<ProgressReport>(talk_.take());
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_DOUBLE_EQ(reports[0].fraction, 0.9);
}

TEST_F(Conversations, ShownPagesAreSaidAfterTheGreeting) {
  ASSERT_TRUE(talk_.show_pages(small_pages_of({0, 2}), {}).is_ok());
  talk_.begin();
  const auto said = say();
  ASSERT_GE(said.size(), 2u);
  EXPECT_TRUE(std::holds_alternative<Greeting>(said[0]));
  ASSERT_TRUE(std::holds_alternative<ShowPages>(said[1]));
  EXPECT_EQ(std::get<ShowPages>(said[1]).added, (std::vector<PageId>{0, 2}));
}

}  // namespace
}  // namespace burnish
