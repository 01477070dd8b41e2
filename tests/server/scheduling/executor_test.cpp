#include "server/scheduling/executor.h"

#include <atomic>
#include <future>
#include <memory>
#include <new>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::ElementsAre;

/// Work that ends on request.
class Gate {
 public:
  std::function<void()> work() {
    return [this] {
      started_.set_value();
      opened_.get_future().wait();
    };
  }
  void wait_until_started() { started_.get_future().wait(); }
  void open() { opened_.set_value(); }

 private:
  std::promise<void> started_, opened_;
};

TEST(Executor, RunsEverythingThatWasPostedBeforeItEnds) {
  std::atomic<int> done{0};
  {
    Executor executor({.threads = 3, .threads_per_holder = 1});
    for (int i = 0; i < 1000; ++i) executor.post({[&] { ++done; }, {}, std::to_string(i % 7)});
  }
  EXPECT_EQ(done, 1000);
}

TEST(Executor, WorkThatThrowsFailsAloneAndTheNextRuns) {
  std::promise<Status> no_memory, other;
  std::promise<void> next;
  Executor executor(1);
  executor.post(
      {[] { throw std::bad_alloc(); }, [&](const Status& status) { no_memory.set_value(status); }});
  executor.post({[] { throw std::runtime_error("by design"); },
                 [&](const Status& status) { other.set_value(status); }});
  executor.post([] { throw std::runtime_error("and nobody hears of it"); });
  EXPECT_EQ(no_memory.get_future().get().code(), StatusCode::kResourceExhausted);
  const Status status = other.get_future().get();
  EXPECT_EQ(status.code(), StatusCode::kInternal);
  EXPECT_THAT(status.message(), testing::HasSubstr("by design"));
  executor.post([&] { next.set_value(); });
  next.get_future().wait();
}

TEST(Executor, HoldersTakeTurnsHoweverMuchOneOfThemHasWaiting) {
  Gate gate;
  std::string order;  // written by one thread
  {
    Executor executor(1);
    executor.post({gate.work(), {}, "anna"});
    gate.wait_until_started();
    for (int i = 0; i < 3; ++i) executor.post({[&] { order += 'a'; }, {}, "anna"});
    executor.post({[&] { order += 'b'; }, {}, "bert"});
    executor.post({[&] { order += 'c'; }, {}, "carl"});
    gate.open();
  }
  EXPECT_EQ(order, "abcaa");
}

TEST(Executor, AHolderThatWaitsInAllItsThreadsLeavesTheOthersFree) {
  Gate first, second;
  std::atomic<bool> third_ran{false};
  std::promise<void> bert;
  Executor executor({.threads = 3, .threads_per_holder = 2});
  executor.post({first.work(), {}, "anna"});
  executor.post({second.work(), {}, "anna"});
  executor.post({[&] { third_ran = true; }, {}, "anna"});
  first.wait_until_started();
  second.wait_until_started();
  executor.post({[&] { bert.set_value(); }, {}, "bert"});
  bert.get_future().wait();
  EXPECT_FALSE(third_ran);
  first.open();
  second.open();
}

class FullExecutor : public testing::Test {
 protected:
  /// Returns the refusal of a piece; "" if it is admitted.
  std::string refusal(const std::string& holder, uint64_t bytes = 0) {
    std::string why;
    executor_.post({[] {},
                    [&](const Status& status) {
                      EXPECT_EQ(status.code(), StatusCode::kResourceExhausted);
                      why = status.message();
                    },
                    holder, bytes});
    return why;
  }
  void SetUp() override {
    executor_.post({gate_.work(), {}, "somebody"});
    gate_.wait_until_started();
  }
  void TearDown() override { gate_.open(); }

  Gate gate_;
  Executor executor_{{.threads = 1,
                      .waiting_per_holder = 2,
                      .bytes_per_holder = 100,
                      .waiting_max = 3,
                      .bytes_max = 150}};
};

TEST_F(FullExecutor, RefusesTheRequestsOfAHolderBeyondItsLimit) {
  EXPECT_EQ(refusal("anna"), "");
  EXPECT_EQ(refusal("anna"), "");
  EXPECT_EQ(refusal("anna"), "anna has 2 requests waiting, the limit is 2");
  EXPECT_EQ(refusal("bert"), "");
}

TEST_F(FullExecutor, RefusesTheBytesOfAHolderBeyondItsLimit) {
  EXPECT_EQ(refusal("anna", 60), "");
  EXPECT_EQ(refusal("anna", 41),
            "requests of anna hold 60 bytes and this one needs 41 more, the limit is 100");
  EXPECT_EQ(refusal("anna", 40), "");
}

TEST_F(FullExecutor, RefusesWhatAllHoldersTogetherAskBeyondTheLimit) {
  EXPECT_EQ(refusal("anna", 90), "");
  EXPECT_EQ(refusal("bert", 61),
            "requests of all users hold 90 bytes and this one needs 61 more, the limit is 150");
  EXPECT_EQ(refusal("bert"), "");
  EXPECT_EQ(refusal("carl"), "");
  EXPECT_EQ(refusal("dora"), "the server has 3 requests waiting, the limit is 3");
}

TEST(ExecutorBytes, ComeBackWhenTheWorkIsDone) {
  Executor executor({.threads = 1, .bytes_per_holder = 100, .bytes_max = 100});
  for (int i = 0; i < 3; ++i) {
    const auto done =
        std::make_shared<std::promise<void>>();  // its setter may end after its waiter
    std::atomic<bool> refused{true};
    while (refused) {  // the last piece gives its bytes back a moment after its work
      refused = false;
      executor.post(
          {[done] { done->set_value(); }, [&](const Status&) { refused = true; }, "anna", 100});
    }
    done->get_future().wait();
  }
}

}  // namespace
}  // namespace burnish
