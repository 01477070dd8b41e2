#include "client/connection/session_link.h"

#include <atomic>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/page_frames/page_frame_decoder.h"
#include "tests/client/connection/fake_editing.h"
#include "tests/client/live/small_surface.h"
#include "tests/common/fast_clock.h"

namespace burnish {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

/// A fake server, a session over it, and the news so far.
class LiveSessions : public testing::Test {
 protected:
  LiveSessions() {
    options_.greeting.session = "work";
    options_.head = small_head();
    options_.depth = small_depth();
    options_.pages_fingerprint = kFakeFingerprint;
    options_.draw_interval = milliseconds(1);
    options_.retry_after_min = milliseconds(5);
    options_.retry_after_max = milliseconds(50);
    options_.clock = clock_.clock();
  }

  void connect() {
    connection_.emplace(Connection::open(server_.address(), milliseconds(10'000)).value());
    session_ = std::make_unique<SessionLink>(*connection_, options_);
    show(pages_);
  }
  void show(const std::vector<PageId>& added, const std::vector<PageId>& removed = {}) {
    const Status status = session_->show_pages(small_pages_of(added), removed);
    EXPECT_TRUE(status.is_ok()) << status.message();
  }

  void take() {
    LiveNews news = session_->take();
    link_ = news.link;
    stats_ = news.stats;
    unacknowledged_ = news.unacknowledged;
    shown_ = news.frame;
    for (LiveEvent& event : news.events) events_.push_back(std::move(event));
  }

  /// Draws until `what` holds. Returns false after the patience.
  template <typename What>
  bool until(What what) {
    for (int i = 0; i < 10'000; ++i) {
      take();
      if (what()) return true;
      std::this_thread::sleep_for(milliseconds(2));
    }
    return false;
  }
  /// Lets the server hear so many more heartbeats, without drawing.
  void pass_heartbeats(int count) const {
    const int last = server_.seen().heartbeats + count;
    for (int i = 0; i < 20'000 && server_.seen().heartbeats < last; ++i)
      std::this_thread::sleep_for(milliseconds(1));
    EXPECT_GE(server_.seen().heartbeats, last);
  }
  bool until_live() {
    return until([this] { return link_ == LinkState::kLive; });
  }
  bool until_shown() {
    return until([this] { return shown_ && server_.is_shown_by(*shown_, pages_); });
  }

  template <typename Event>
  std::vector<Event> told() const {
    std::vector<Event> of_kind;
    for (const LiveEvent& event : events_)
      if (const auto* found = std::get_if<Event>(&event)) of_kind.push_back(*found);
    return of_kind;
  }

  static std::vector<Edit> slider(const std::string& id, double beta = 0.5) {
    return {Edit{id, SetGradientScale{beta}}};
  }

  FakeEditing server_;
  FastClock clock_;
  LiveOptions options_;
  std::optional<Connection> connection_;
  std::unique_ptr<SessionLink> session_;

  LinkState link_ = LinkState::kConnecting;
  LinkStats stats_;
  size_t unacknowledged_ = 0;
  std::vector<PageId> pages_ = {0, 2, 3};  // that are shown
  std::shared_ptr<const SurfaceFrame> shown_;
  std::vector<LiveEvent> events_;
};

TEST_F(LiveSessions, ShowEachSurfaceOfTheServer) {
  connect();
  ASSERT_TRUE(until_live());
  ASSERT_TRUE(until_shown());
  for (const double phase : {1.0, 2.0, 3.0}) {
    server_.show(phase);
    ASSERT_TRUE(until_shown()) << phase;
  }
  EXPECT_TRUE(stats_.frame.settled);
  EXPECT_GE(stats_.frames, 4u);
  EXPECT_GT(stats_.bytes, 0u);
  EXPECT_TRUE(until([this] { return stats_.rtt_ms > 0; }));
  const auto welcomed = told<Welcome>();
  ASSERT_EQ(welcomed.size(), 1u);
  EXPECT_EQ(welcomed[0].session.name, "work");
  EXPECT_EQ(welcomed[0].connection, 7u);
  EXPECT_EQ(welcomed[0].role, SessionRole::kEditor);
}

TEST_F(LiveSessions, TellOfEditsOnceTheyAreOnDiskAndOnceTheyAreShown) {
  connect();
  ASSERT_TRUE(session_->apply(slider("a")).is_ok());
  ASSERT_TRUE(session_->apply(slider("b")).is_ok());
  EXPECT_TRUE(session_->wait_until_acknowledged(milliseconds(20'000)));
  ASSERT_TRUE(until([this] { return told<EditsShown>().size() == 2; }));
  const auto acknowledged = told<EditsAcknowledged>();
  ASSERT_EQ(acknowledged.size(), 2u);
  EXPECT_THAT(acknowledged[0].edit_ids, ElementsAre("a"));
  EXPECT_EQ(acknowledged[1].outcome.edits, 2u);
  EXPECT_EQ(unacknowledged_, 0u);
  EXPECT_THAT(server_.seen().applied, ElementsAre("a", "b"));
}

TEST_F(LiveSessions, LoseNoEditWhenTheServerIsGoneBeforeItsAnswer) {
  server_.set_faults({.answer_no_edits = true});
  connect();
  ASSERT_TRUE(until_live());  // otherwise there is no link to lose
  ASSERT_TRUE(session_->apply(slider("a")).is_ok());
  ASSERT_TRUE(until([this] { return server_.seen().applied.size() == 1; }));
  server_.stop();
  ASSERT_TRUE(until([this] { return link_ == LinkState::kLost; }));
  ASSERT_TRUE(session_->apply(slider("b")).is_ok());
  EXPECT_EQ(told<EditsAcknowledged>().size(), 0u);

  server_.set_faults({});
  server_.start();
  ASSERT_TRUE(until([this] { return told<EditsAcknowledged>().size() == 2; }));
  EXPECT_EQ(link_, LinkState::kLive);
  EXPECT_EQ(server_.seen().repeated, 1);
  EXPECT_THAT(server_.seen().applied, ElementsAre("a", "b"));
  EXPECT_TRUE(until_shown());
}

TEST_F(LiveSessions, HaveAServerThatEndedStartedAgainHoweverOftenThatFails) {
  std::atomic<int> tries = 0;
  std::atomic<bool> has_ended = false;
  connection_.emplace(Connection::open(server_.address(), milliseconds(10'000)).value());
  connection_->set_starter([&](const Progress& progress) {
    EXPECT_TRUE(report(progress, "", 0));
    if (++tries == 2) {
      has_ended.wait(false);  // the link is lost before stop() returns
      return not_found("no such program");
    }
    if (tries == 3) server_.start();
    return Status::ok();
  });
  session_ = std::make_unique<SessionLink>(*connection_, options_);
  ASSERT_TRUE(until_live());
  server_.stop();
  has_ended = true;
  has_ended.notify_all();
  ASSERT_TRUE(session_->apply(slider("a")).is_ok());
  EXPECT_TRUE(session_->wait_until_acknowledged(milliseconds(20'000)));
  EXPECT_EQ(tries, 3);
}

TEST_F(LiveSessions, ShowAllPagesAnewAfterTheyCameBack) {
  connect();
  ASSERT_TRUE(until_shown());
  const auto before = shown_;
  const int credits = server_.seen().credits_before_pages;
  server_.stop();
  server_.show(2);
  server_.start();
  ASSERT_TRUE(until_shown());
  EXPECT_NE(shown_->find(0), before->find(0));
  EXPECT_GT(shown_->number, before->number);
  ASSERT_EQ(server_.seen().changes.size(), 2u);
  EXPECT_EQ(server_.seen().changes[1].revision(), 1u);
  EXPECT_EQ(server_.seen().changes[1].added_size(), 3);
  EXPECT_EQ(server_.seen().credits_before_pages, credits);
}

TEST_F(LiveSessions, ComeBackManyTimes) {
  connect();
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(until_live());
    ASSERT_TRUE(session_->apply(slider("edit" + std::to_string(i))).is_ok());
    server_.stop();
    server_.show(0.1 * i);
    server_.start();
    ASSERT_TRUE(until([&] { return server_.seen().greetings >= i + 2; }));
  }
  EXPECT_TRUE(session_->wait_until_acknowledged(milliseconds(20'000)));
  EXPECT_EQ(server_.seen().applied.size(), 10u);
  EXPECT_TRUE(until_shown());
}

TEST_F(LiveSessions, TellWhyAnEditWasRefusedAndForgetIt) {
  server_.set_faults({.refuse_edits = grpc::StatusCode::PERMISSION_DENIED});
  connect();
  ASSERT_TRUE(session_->apply(slider("a")).is_ok());
  ASSERT_TRUE(until([this] { return !told<EditsRefused>().empty(); }));
  EXPECT_THAT(told<EditsRefused>()[0].edit_ids, ElementsAre("a"));
  EXPECT_EQ(told<EditsRefused>()[0].status.code(), StatusCode::kPermissionDenied);
  EXPECT_EQ(told<EditsRefused>()[0].status.message(), "not today");
  EXPECT_EQ(unacknowledged_, 0u);
}

TEST_F(LiveSessions, KeepAnEditThatTheServerCannotTakeNow) {
  server_.set_faults({.refuse_edits = grpc::StatusCode::UNAVAILABLE});
  connect();
  ASSERT_TRUE(session_->apply(slider("a")).is_ok());
  ASSERT_TRUE(until([this] { return server_.seen().greetings >= 3; }));
  EXPECT_EQ(unacknowledged_, 1u);
  server_.set_faults({});
  EXPECT_TRUE(session_->wait_until_acknowledged(milliseconds(20'000)));
  EXPECT_THAT(server_.seen().applied, ElementsAre("a"));
}

TEST_F(LiveSessions, AskForAKeyFrameWhenAFrameIsDamaged) {
  connect();
  ASSERT_TRUE(until_shown());
  server_.set_faults({.corrupt_frames = 1});
  server_.show(1);
  ASSERT_TRUE(until_shown());
  EXPECT_EQ(server_.seen().key_frame_requests, 1);
  EXPECT_EQ(server_.seen().greetings, 1);
}

TEST_F(LiveSessions, RefuseAFrameWhoseReferenceTheyDoNotHold) {
  connect();
  ASSERT_TRUE(until_shown());
  server_.set_faults({.lost_frames = 1});
  server_.show(1);
  ASSERT_TRUE(until([this] { return server_.seen().frames >= 2; }));
  server_.show(2);
  ASSERT_TRUE(until_shown());
  EXPECT_GE(server_.seen().refused_frames, 1);
}

TEST_F(LiveSessions, DoNotMindALateFrame) {
  server_.set_faults({.late_frames = 3});
  connect();
  for (const double phase : {1.0, 2.0, 3.0}) {
    server_.show(phase);
    ASSERT_TRUE(until_shown());
  }
  EXPECT_EQ(server_.seen().greetings, 1);
}

TEST_F(LiveSessions, ComeBackWhenTheServerSaysSoAndEndWhenItDoesNot) {
  connect();
  ASSERT_TRUE(until_live());
  server_.go_away("restarting", true);
  ASSERT_TRUE(until([this] { return server_.seen().greetings == 2; }));
  ASSERT_TRUE(until_live());
  server_.go_away("the session is deleted", false);
  ASSERT_TRUE(until([this] { return link_ == LinkState::kEnded; }));
  EXPECT_THAT(told<LinkChanged>().back().reason, HasSubstr("the session is deleted"));
  EXPECT_EQ(session_->apply(slider("a")).code(), StatusCode::kFailedPrecondition);
}

TEST_F(LiveSessions, CountRefusedPagesWhenTheGoAwaySaysSoAlone) {
  connect();
  ASSERT_TRUE(until_live());
  server_.go_away("restarting", true, v1::GO_AWAY_CODE_GOING_DOWN);
  ASSERT_TRUE(until([this] { return server_.seen().greetings == 2; }));
  ASSERT_TRUE(until_live());
  EXPECT_EQ(session_->take().pages_refused, 0u);
  server_.go_away("too many", true, v1::GO_AWAY_CODE_TOO_MANY_PAGES);
  ASSERT_TRUE(until([this] { return server_.seen().greetings == 3; }));
  EXPECT_EQ(session_->take().pages_refused, 1u);
}

TEST_F(LiveSessions, EndWhenTheServerWillNeverHaveThem) {
  server_.set_faults({.refuse_greeting = grpc::StatusCode::NOT_FOUND});
  connect();
  ASSERT_TRUE(until([this] { return link_ == LinkState::kEnded; }));
  EXPECT_THAT(told<LinkChanged>().back().reason, HasSubstr("go elsewhere"));
}

TEST_F(LiveSessions, ShowOtherPagesAtAnyTime) {
  pages_.clear();
  connect();
  ASSERT_TRUE(until_shown());
  for (PageId page = 0; page < 6; ++page) {
    show({page});
    pages_.push_back(page);
    ASSERT_TRUE(until_shown()) << page;
  }
  show({7}, {0, 3});
  pages_ = {1, 2, 4, 5, 7};
  ASSERT_TRUE(until_shown());
  EXPECT_EQ(server_.seen().key_frame_requests, 0);
}

TEST_F(LiveSessions, RefuseAWrongChangeOfPagesAtOnce) {
  connect();
  EXPECT_EQ(session_->show_pages(small_pages_of({0}), {}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(session_->show_pages({}, {5}).code(), StatusCode::kInvalidArgument);
  EXPECT_TRUE(until_shown());
}

TEST_F(LiveSessions, SayManyChangesOfPagesAsFewOnesWhileNoFrameComes) {
  options_.heartbeat_interval = milliseconds(1);
  connect();
  ASSERT_TRUE(until_live());
  server_.set_faults({.make_no_frames = true});
  for (int i = 0; i < 300; ++i) {
    show({5});
    show({6}, {5});
    take();
    show({}, {6});
  }
  show({7});
  pages_.push_back(7);
  pass_heartbeats(3);
  EXPECT_LE(server_.seen().changes.size(), kPageChangesInFlightMax + 1);
  server_.set_faults({});
  ASSERT_TRUE(until_shown());
  EXPECT_EQ(server_.seen().greetings, 1);
}

TEST_F(LiveSessions, GoOnWhenTheServerChangesTheKindOfFrames) {
  connect();
  for (const PageFrameKind kind : {PageFrameKind::kCorners, PageFrameKind::kVertices}) {
    ASSERT_TRUE(until_shown());
    server_.send(kind);
    ASSERT_TRUE(until_shown());
    show({static_cast<PageId>(pages_.back() + 1)});
    pages_.push_back(pages_.back() + 1);
    server_.show(1);
    ASSERT_TRUE(until_shown());
  }
  EXPECT_EQ(server_.seen().key_frame_requests, 0);
  EXPECT_EQ(server_.seen().greetings, 1);
}

TEST_F(LiveSessions, EndWhenTheScanHasOtherPages) {
  server_.set_faults({.fingerprint_change = 1});
  connect();
  ASSERT_TRUE(until([this] { return link_ == LinkState::kEnded; }));
  EXPECT_THAT(told<LinkChanged>().back().reason, HasSubstr("must be opened again"));
}

TEST_F(LiveSessions, LeaveAServerThatHasFallenSilent) {
  connect();
  ASSERT_TRUE(until_live());
  server_.set_faults({.silent = true});
  ASSERT_TRUE(until([this] {
    clock_.put_forward(seconds(1));
    return link_ == LinkState::kLost;
  }));
  EXPECT_THAT(told<LinkChanged>().back().reason, HasSubstr("nothing was heard for 15 s"));
  server_.set_faults({});
  // The link may have come back to the silent server already. Then it must fall silent once more.
  EXPECT_TRUE(until([this] {
    clock_.put_forward(milliseconds(10));
    return link_ == LinkState::kLive;
  }));
}

TEST_F(LiveSessions, StayWithAServerThatHasNothingToSayButHeartbeats) {
  connect();
  ASSERT_TRUE(until_shown());
  for (int i = 0; i < 10; ++i) {
    const int before = server_.seen().heartbeats;
    clock_.put_forward(seconds(5));  // of the 15 for which it may be silent
    ASSERT_TRUE(until([&] { return server_.seen().heartbeats >= before + 2; }));
  }
  EXPECT_EQ(link_, LinkState::kLive);
  EXPECT_EQ(server_.seen().greetings, 1);
}

TEST_F(LiveSessions, WaitForAServerThatIsNotThereYet) {
  connect();
  ASSERT_TRUE(until_live());
  session_.reset();
  server_.stop();
  events_.clear();
  session_ = std::make_unique<SessionLink>(*connection_, options_);
  ASSERT_TRUE(until([this] { return !told<LinkChanged>().empty(); }));  // a first try has failed
  EXPECT_EQ(link_, LinkState::kConnecting);
  server_.start();
  EXPECT_TRUE(until_live());
}

TEST_F(LiveSessions, SendPreviewsInPartsAndTheWholeAgainOnTheNextStream) {
  connect();
  ASSERT_TRUE(until_live());
  const Brush brush{.radius = 1, .strength = 1, .beta = 2};
  const auto previews = [this] { return server_.seen().previews; };
  session_->preview("s", Stroke{brush, {Vec3d(0, 0, 0), Vec3d(1, 0, 0)}});
  ASSERT_TRUE(until([&] { return previews().size() == 1; }));
  session_->preview("s", Stroke{brush, {Vec3d(2, 0, 0)}});
  ASSERT_TRUE(until([&] { return previews().size() == 2; }));
  EXPECT_EQ(previews()[0].stroke().path_size(), 2);
  ASSERT_EQ(previews()[1].stroke().path_size(), 1);
  EXPECT_EQ(previews()[1].stroke().path(0).x(), 2);
  ASSERT_TRUE(until([this] { return !told<PreviewShown>().empty(); }));

  server_.stop();
  server_.start();
  ASSERT_TRUE(until([&] { return previews().size() == 3; }));
  EXPECT_EQ(previews()[2].stroke().path_size(), 3);
  session_->drop_preview("s");
  ASSERT_TRUE(until([&] { return previews().size() == 4; }));
  EXPECT_TRUE(previews()[3].has_drop());
}

TEST_F(LiveSessions, SayWhereTheBrushIs) {
  connect();
  ASSERT_TRUE(until_live());
  session_->move_brush(BrushRing{Vec3d(1, 2, 3), 4});
  ASSERT_TRUE(until([this] { return server_.seen().rings.size() == 1; }));
  EXPECT_EQ(server_.seen().rings[0].ring().centre().z(), 3);
  session_->move_brush(std::nullopt);
  ASSERT_TRUE(until([this] { return server_.seen().rings.size() == 2; }));
  EXPECT_FALSE(server_.seen().rings[1].has_ring());
}

TEST_F(LiveSessions, RefuseWhatNoServerWouldTake) {
  connect();
  EXPECT_EQ(session_->apply({}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(session_->apply(slider("a", 11)).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(session_->apply(slider("a b")).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(session_->apply({65, slider("a")[0]}).code(), StatusCode::kInvalidArgument);
  EXPECT_EQ(session_->apply({{"c", SetCellFields{}}}).code(), StatusCode::kInvalidArgument);
}

TEST_F(LiveSessions, AskForNoFrameThatNobodyDraws) {
  options_.heartbeat_interval = milliseconds(1);
  connect();
  ASSERT_TRUE(until_shown());
  const int before = server_.seen().frames;
  for (int i = 1; i <= 20; ++i) {
    server_.show(0.1 * i);
    pass_heartbeats(2);  // with the second it has sent what it had to say after the first
  }
  EXPECT_LE(server_.seen().frames, before + 8);
  EXPECT_TRUE(until_shown());
}

TEST_F(LiveSessions, CanBeLeftAtAnyMoment) {
  for (int i = 0; i < 30; ++i) {
    connect();
    ASSERT_TRUE(session_->apply(slider("a")).is_ok());
    std::this_thread::sleep_for(milliseconds(i % 6));  // waits for nothing: picks the moment
    session_.reset();
  }
  EXPECT_LE(server_.seen().applied.size(), 1u);
}

}  // namespace
}  // namespace burnish
