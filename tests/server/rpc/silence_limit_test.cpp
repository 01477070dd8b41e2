#include "server/rpc/reactor/silence_limit.h"

#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;

/// A call with a limit.
struct TimedCall : std::enable_shared_from_this<TimedCall> {
  explicit TimedCall(milliseconds limit) : silence(limit) {}
  void start() {
    silence.start(weak_from_this(), [this](const Status& status) { ended.set_value(status); });
  }
  SilenceLimit silence;
  std::promise<Status> ended;
};

TEST(SilenceLimit, TellsOfAClientThatIsWaitedForAndSendsNothing) {
  const auto call = std::make_shared<TimedCall>(milliseconds(1));
  call->start();
  call->silence.wait();
  const Status status = call->ended.get_future().get();
  EXPECT_EQ(status.code(), StatusCode::kDeadlineExceeded);
  EXPECT_THAT(status.message(), testing::HasSubstr("the client has sent nothing"));
  EXPECT_FALSE(call->silence.heard());  // a message comes too late
}

TEST(SilenceLimit, WhoIsNotWaitedForMayBeSilent) {
  const auto busy = std::make_shared<TimedCall>(milliseconds(1));
  busy->start();
  busy->silence.wait();
  const bool was_in_time = busy->silence.heard();  // may be false on a slow machine
  const auto other = std::make_shared<TimedCall>(milliseconds(1));
  other->start();
  other->silence.wait();
  other->ended.get_future().wait();  // by now the first one's alarm has also rung
  EXPECT_EQ(busy->silence.heard(), was_in_time);
}

TEST(SilenceLimit, ACallThatIsGoneHearsNothing) {
  auto call = std::make_shared<TimedCall>(milliseconds(1));
  call->start();
  call->silence.wait();
  call->silence.stop();
  call.reset();
}

}  // namespace
}  // namespace burnish
