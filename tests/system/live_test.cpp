// The live stream of a real server, message by message.

#include <csignal>
#include <cstring>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/metrics/http_get.h"
#include "tests/system/live_stream.h"
#include "tests/system/server_process.h"
#include "tests/system/wire_call.h"

namespace burnish {
namespace {

using grpc::StatusCode;
using testing::ElementsAre;
using testing::HasSubstr;
using Case = v1::ServerMessage;

/// A server with a session "work" over a sphere.
class Live : public testing::Test {
 protected:
  Live() {
    done({"import", write_sphere(server_.folder), "--depth", "4", "--name", "ball"});
    done({"open", "ball", "--depth", "4", "--session", "work", "--user", "ann"});
  }

  void done(std::vector<std::string> words) {
    const CommandOutcome outcome = server_.burnish(std::move(words));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
  }

  std::shared_ptr<grpc::Channel> channel() { return wire_channel(server_.address); }

  ServerProcess server_{{"--metrics", "127.0.0.1:0"}};
};

TEST_F(Live, AClientIsWelcomedAndSeesASettledSurfaceThenSilence) {
  LiveStream ann(channel(), "ann");
  ann.greet("work");
  const v1::Welcome welcome = ann.next(Case::kWelcome).welcome();
  EXPECT_EQ(welcome.session().name(), "work");
  EXPECT_EQ(welcome.role(), v1::ROLE_OWNER);
  EXPECT_NE(welcome.pages_fingerprint(), 0u);
  EXPECT_EQ(welcome.backend(), "cpu");
  ann.credit(8);
  const v1::Frame frame = ann.settle();
  EXPECT_EQ(frame.state(), v1::SOLVE_STATE_SETTLED);
  EXPECT_GT(frame.cycles(), 0);
  // A heartbeat comes back, without a frame before it, although there are credits.
  ann.seen.clear();
  ann.credit(8, {sequence_of(frame)});
  ann.beat(7);
  EXPECT_EQ(ann.next(Case::kHeartbeat).heartbeat().client_time_us(), 7u);
  for (const v1::ServerMessage& message : ann.seen) EXPECT_FALSE(message.has_frame());
  ann.half_close();
  EXPECT_TRUE(ann.end().ok());
}

TEST_F(Live, AnEditIsAcknowledgedAndReachesTheFramesOfEverybody) {
  LiveStream ann(channel(), "ann"), bob(channel(), "bob");
  for (LiveStream* stream : {&ann, &bob}) {
    stream->greet("work");
    stream->next(Case::kWelcome);
    stream->credit(2);
    stream->settle();
    stream->credit(2);
  }
  ann.slide("a1", 0.5);
  const v1::Acknowledged answer = ann.next(Case::kAcknowledged).acknowledged();
  EXPECT_THAT(answer.edit_ids(), ElementsAre("a1"));
  EXPECT_EQ(answer.outcome().applied(), 1u);
  EXPECT_THAT(answer.outcome().entries(), ElementsAre(1u));
  const auto has_seen_it = [](const v1::ServerMessage& message) {
    return message.has_frame() && message.frame().edits() == 1;
  };
  EXPECT_TRUE(bob.next(has_seen_it).has_frame());
  const bool bob_was_told =
      std::any_of(bob.seen.begin(), bob.seen.end(), [](const v1::ServerMessage& message) {
        return message.has_history() && message.history().gradient_scale() == 0.5;
      });
  EXPECT_TRUE(bob_was_told || bob.next(Case::kHistory).history().gradient_scale() == 0.5);
}

TEST_F(Live, AnEditOfAnotherKindOfCallReachesTheFramesToo) {
  LiveStream ann(channel(), "ann");
  ann.greet("work");
  ann.next(Case::kWelcome);
  ann.credit(2);
  ann.settle();
  ann.credit(2);
  done({"edit", "work", "--beta", "0.25", "--user", "ann"});
  EXPECT_TRUE(ann.next([](const v1::ServerMessage& message) {
                   return message.has_frame() && message.frame().edits() == 1;
                 })
                  .has_frame());
}

TEST_F(Live, APreviewIsShownAndKeptNowhere) {
  LiveStream ann(channel(), "ann");
  ann.greet("work");
  ann.next(Case::kWelcome);
  ann.credit(1);
  const v1::Frame before = ann.settle();
  ann.credit(1, {sequence_of(before)});
  ann.preview_slide("drag", 0.2);
  const v1::Frame shown = ann.next(Case::kFrame).frame();
  EXPECT_EQ(shown.previews(), 1u);
  EXPECT_EQ(shown.edits(), 0u);
  EXPECT_GT(shown.data().size(), 64u);
  const CommandOutcome sessions = server_.burnish({"sessions", "work", "--json"});
  EXPECT_THAT(sessions.output, HasSubstr("\"edits\": 0"));
}

TEST_F(Live, AViewerIsRefusedAndWatchesOn) {
  done({"people", "work", "--give", "bob", "--role", "viewer", "--user", "ann"});
  LiveStream bob(channel(), "bob");
  bob.greet("work");
  EXPECT_EQ(bob.next(Case::kWelcome).welcome().role(), v1::ROLE_VIEWER);
  bob.slide("b1", 0.5);
  const v1::Refused refused = bob.next(Case::kRefused).refused();
  EXPECT_THAT(refused.edit_ids(), ElementsAre("b1"));
  EXPECT_EQ(refused.code(), StatusCode::PERMISSION_DENIED);
  EXPECT_THAT(refused.message(), HasSubstr("'bob' is viewer"));
  bob.preview_slide("b2", 0.5);
  EXPECT_EQ(bob.next(Case::kRefused).refused().code(), StatusCode::PERMISSION_DENIED);
  bob.credit(1);
  EXPECT_TRUE(bob.next(Case::kFrame).has_frame());
}

TEST_F(Live, WrongEditsAreRefusedWithTheValueAndItsLimit) {
  LiveStream ann(channel(), "ann");
  ann.greet("work");
  ann.next(Case::kWelcome);
  ann.slide("a1", 11);
  const v1::Refused refused = ann.next(Case::kRefused).refused();
  EXPECT_EQ(refused.code(), StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(refused.message(), HasSubstr("11"));
  EXPECT_THAT(refused.edit_ids(), ElementsAre("a1"));
  ann.preview_slide("a2", -1);
  EXPECT_EQ(ann.next(Case::kRefused).refused().code(), StatusCode::INVALID_ARGUMENT);
}

TEST_F(Live, AStreamThatDoesNotBeginWithAGreetingIsEnded) {
  LiveStream ann(channel());
  ann.credit(1);
  const grpc::Status status = ann.end();
  EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(status.error_message(), HasSubstr("begin with a greeting"));
  LiveStream bob(channel());
  bob.greet("nothing");
  EXPECT_EQ(bob.end().error_code(), StatusCode::NOT_FOUND);
}

TEST_F(Live, AMessageThatItsStreamDoesNotTakeEndsItIsLoggedAndCounted) {
  v1::ClientMessage second_greeting, of_too_many, nothing;
  second_greeting.mutable_greeting()->set_session("work");
  second_greeting.mutable_greeting()->set_pages(true);
  for (uint64_t i = 0; i < 257; ++i) of_too_many.mutable_credit()->add_decoded(i);
  double refused = 0;
  for (const v1::ClientMessage& wrong : {second_greeting, of_too_many, nothing}) {
    LiveStream ann(channel(), "ann");
    ann.greet("work");
    ann.next(Case::kWelcome);
    ann.send(wrong);
    const grpc::Status status = ann.end();
    EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
    EXPECT_TRUE(server_.process->wait_for_output(status.error_message(), kPatience));
    const int port = std::stoi(server_.announced("metrics on port "));
    EXPECT_EQ(metric(http_get_metrics(port), "burnish_refusals_total{reason=\"malformed\"}"),
              ++refused);
  }
}

TEST_F(Live, BytesThatAreNoMessageEndTheirStreamAreLoggedAndCounted) {
  v1::ClientMessage greeting;
  greeting.mutable_greeting()->set_session("work");
  greeting.mutable_greeting()->set_pages(true);
  const WireAnswer answer =
      call(channel(), {.method = "/burnish.v1.Editing/Edit",
                       .messages = {greeting.SerializeAsString(), "\xff\xff\xff"},
                       .keep_open = true});
  EXPECT_EQ(answer.status.error_code(), StatusCode::INVALID_ARGUMENT);
  EXPECT_THAT(answer.status.error_message(), HasSubstr("not a valid ClientMessage"));
  EXPECT_TRUE(server_.process->wait_for_output("not a valid ClientMessage", kPatience));
  const int port = std::stoi(server_.announced("metrics on port "));
  EXPECT_EQ(metric(http_get_metrics(port), "burnish_refusals_total{reason=\"malformed\"}"), 1);
}

TEST_F(Live, PeopleComeMoveTheirBrushAndGo) {
  LiveStream ann(channel(), "ann");
  ann.greet("work");
  ann.next(Case::kWelcome);
  const auto present = [](size_t people) {
    return [people](const v1::ServerMessage& message) {
      return message.has_people() && message.people().present_size() == static_cast<int>(people);
    };
  };
  {
    LiveStream bob(channel(), "bob");
    bob.greet("work");
    EXPECT_TRUE(ann.next(present(2)).has_people());
    v1::ClientMessage move;
    move.mutable_move_brush()->mutable_ring()->set_radius(0.25);
    move.mutable_move_brush()->mutable_ring()->mutable_centre()->set_x(1);
    bob.send(move);
    const auto ring = ann.next([](const v1::ServerMessage& message) {
      return message.has_people() && message.people().present_size() == 2 &&
             message.people().present(1).has_ring();
    });
    EXPECT_EQ(ring.people().present(1).user(), "bob");
    EXPECT_EQ(ring.people().present(1).ring().radius(), 0.25);
  }
  EXPECT_TRUE(ann.next(present(1)).has_people());
}

TEST_F(Live, ADrainingServerAnswersFirstAndTellsToComeBack) {
  LiveStream ann(channel(), "ann");
  ann.greet("work");
  ann.next(Case::kWelcome);
  ann.slide("a1", 0.5);
  ann.next(Case::kAcknowledged);
  server_.process->signal(SIGTERM);
  const v1::GoAway go_away = ann.next(Case::kGoAway).go_away();
  EXPECT_TRUE(go_away.come_back());
  EXPECT_THAT(go_away.reason(), HasSubstr("going down"));
  EXPECT_TRUE(ann.end().ok());
  EXPECT_EQ(server_.process->wait(kPatience), 0) << server_.process->output();
}

TEST_F(Live, AClosedOrDeletedSessionSendsItsClientsAway) {
  for (const bool deleted : {false, true}) {
    LiveStream ann(channel(), "ann");
    ann.greet("work");
    ann.next(Case::kWelcome);
    std::vector<std::string> words = {"close", "work", "--user", "ann"};
    if (deleted) words.insert(words.begin() + 2, "--delete");
    std::vector<std::string> of_another = words;
    of_another.back() = "bob";
    EXPECT_THAT(server_.burnish(of_another).output, HasSubstr("'bob' is editor of this session"));
    done(words);
    EXPECT_FALSE(ann.next(Case::kGoAway).go_away().come_back());
    EXPECT_TRUE(ann.end().ok());
  }
}

TEST_F(Live, AfterAKilledServerAnEditSentAgainIsKnown) {
  auto before = std::make_unique<LiveStream>(channel(), "ann");
  before->greet("work");
  before->next(Case::kWelcome);
  before->slide("a1", 0.5);
  before->next(Case::kAcknowledged);
  server_.kill();
  EXPECT_EQ(before->end().error_code(), StatusCode::UNAVAILABLE);
  server_.start();
  LiveStream after(channel(), "ann");
  after.greet("work");
  EXPECT_EQ(after.next(Case::kWelcome).welcome().session().edits(), 1u);
  after.slide("a1", 0.5);
  after.slide("a2", 0.25);
  EXPECT_EQ(after.next(Case::kAcknowledged).acknowledged().outcome().known(), 1u);
  const v1::Acknowledged second = after.next(Case::kAcknowledged).acknowledged();
  EXPECT_EQ(second.outcome().applied(), 1u);
  EXPECT_EQ(second.outcome().edits(), 2u);
}

TEST_F(Live, WatchersGetKeyFrames) {
  const auto stub = v1::Editing::NewStub(channel());
  grpc::ClientContext context;
  v1::WatchRequest request;
  request.mutable_greeting()->set_session("work");
  request.mutable_greeting()->set_pages(true);
  request.add_pages(0);
  const auto stream = stub->Watch(&context, request);
  v1::ServerMessage message;
  int frames = 0;
  bool settled = false;
  while (!settled && stream->Read(&message)) {
    if (!message.has_frame()) continue;
    ++frames;
    uint64_t reference = 1;
    std::memcpy(&reference, message.frame().data().data() + 16, sizeof(reference));
    EXPECT_EQ(reference, 0u);
    settled = message.frame().state() == v1::SOLVE_STATE_SETTLED;
  }
  EXPECT_GT(frames, 0);
  EXPECT_TRUE(settled);
  context.TryCancel();
  EXPECT_EQ(stream->Finish().error_code(), StatusCode::CANCELLED);
}

TEST_F(Live, NothingIsLeftOfStreamsThatHaveEnded) {
  for (int i = 0; i < 20; ++i) {
    LiveStream stream(channel(), "ann");
    stream.greet("work");
    if (i % 2 == 0) stream.next(Case::kWelcome);
    if (i % 4 == 0) stream.slide("edit" + std::to_string(i), 0.5);
    if (i % 5 == 0) stream.half_close();
  }
  const int port = std::stoi(server_.announced("metrics on port "));
  for (const char* kind : {"call", "stream", "live_session"}) {
    const std::string gauge = std::string("burnish_live_objects{kind=\"") + kind + "\"}";
    double alive = -1;
    for (int i = 0; i < 3000 && alive != 0; ++i) {
      alive = metric(http_get_metrics(port), gauge);
      if (alive != 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_EQ(alive, 0) << kind;
  }
}

}  // namespace
}  // namespace burnish
