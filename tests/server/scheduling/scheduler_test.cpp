#include "server/scheduling/scheduler.h"

#include <atomic>
#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

/// Takes a number of turns, each some milliseconds of the test's clock.
struct Worker : Scheduled {
  Worker(double& test_clock, double turn_ms, int turns_to_do)
      : clock(test_clock), cost_ms(turn_ms), left(turns_to_do) {}
  bool turn() override {
    clock += cost_ms;
    taken_ms += cost_ms;
    ++turns;
    return --left > 0;
  }
  double& clock;
  const double cost_ms;
  int left;
  int turns = 0;
  double taken_ms = 0;
};

class SchedulerTest : public testing::Test {
 protected:
  std::shared_ptr<Worker> worker(double cost_ms, int turns = 1'000'000) {
    auto made = std::make_shared<Worker>(clock_, cost_ms, turns);
    scheduler_.wake(made);
    return made;
  }

  double clock_ = 0;
  Scheduler scheduler_{0, [this] { return clock_; }};
};

TEST_F(SchedulerTest, LargeAndSmallSessionsGetTheSameTime) {
  const auto large = worker(100), middle = worker(20), small = worker(1);
  while (clock_ < 30'000) scheduler_.run_one();
  for (const auto& each : {large, middle, small}) EXPECT_NEAR(each->taken_ms, 10'000, 200);
}

TEST_F(SchedulerTest, EightAlikeNeverWaitForMoreThanTheOthersTurnsAndAQuantum) {
  std::vector<std::shared_ptr<Worker>> workers;
  for (int i = 0; i < 8; ++i) workers.push_back(worker(4));
  for (int turn = 0; turn < 800; ++turn) {
    scheduler_.run_one();
    int least = workers[0]->turns, most = least;
    for (const auto& each : workers) {
      least = std::min(least, each->turns);
      most = std::max(most, each->turns);
    }
    EXPECT_LE(most - least, 3);
  }
}

TEST_F(SchedulerTest, WhoHasNoWorkCostsNothing) {
  const auto settled = worker(10, 3), other = worker(10, 5);
  while (scheduler_.run_one()) {
  }
  EXPECT_EQ(settled->turns, 3);
  EXPECT_EQ(other->turns, 5);
  EXPECT_EQ(scheduler_.waiting(), 0u);
}

TEST_F(SchedulerTest, IdleTimeIsNotSavedUp) {
  const auto busy = worker(1);
  const auto sleeper = worker(1, 1);
  while (clock_ < 10'000) scheduler_.run_one();
  sleeper->left = 1'000'000;
  sleeper->taken_ms = busy->taken_ms = 0;
  scheduler_.wake(sleeper);
  while (clock_ < 11'000) scheduler_.run_one();
  EXPECT_NEAR(sleeper->taken_ms, 500, 20);
}

TEST_F(SchedulerTest, WakingTwiceIsWakingOnce) {
  const auto once = worker(1, 1);
  scheduler_.wake(once);
  EXPECT_TRUE(scheduler_.run_one());
  EXPECT_FALSE(scheduler_.run_one());
  EXPECT_EQ(once->turns, 1);
}

TEST_F(SchedulerTest, WhoIsWokenDuringItsTurnGetsAnother) {
  struct Self : Scheduled, std::enable_shared_from_this<Self> {
    explicit Self(Scheduler& its) : scheduler(its) {}
    bool turn() override {
      if (++turns == 1) scheduler.wake(shared_from_this());
      return false;
    }
    Scheduler& scheduler;
    int turns = 0;
  };
  const auto self = std::make_shared<Self>(scheduler_);
  scheduler_.wake(self);
  while (scheduler_.run_one()) {
  }
  EXPECT_EQ(self->turns, 2);
}

TEST_F(SchedulerTest, WorkBesideItGivesWayOnlyWhileThereIsSomeAndOnlySoLong) {
  scheduler_.give_way(std::chrono::hours(1));  // nobody works
  const auto busy = worker(1, 3);
  scheduler_.give_way(std::chrono::milliseconds(1));
  std::thread others([this] {
    while (scheduler_.run_one()) {
    }
  });
  scheduler_.give_way(std::chrono::hours(1));
  EXPECT_EQ(busy->turns, 3);
  others.join();
}

TEST(SchedulerThreads, TakeEachTurnOnceAndNeverTwoOfTheSame) {
  struct Counting : Scheduled {
    bool turn() override {
      EXPECT_FALSE(inside.exchange(true));
      inside = false;
      if (++turns < 200) return true;
      done.set_value();
      return false;
    }
    std::atomic<bool> inside{false};
    std::atomic<int> turns{0};
    std::promise<void> done;
  };
  std::vector<std::shared_ptr<Counting>> all;
  for (int i = 0; i < 5; ++i) all.push_back(std::make_shared<Counting>());
  Scheduler scheduler(3);
  for (const auto& each : all) scheduler.wake(each);
  for (const auto& each : all) each->done.get_future().wait();
  for (const auto& each : all) EXPECT_EQ(each->turns, 200);
}

}  // namespace
}  // namespace burnish
