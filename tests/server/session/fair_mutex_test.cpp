#include "server/session/fair_mutex.h"

#include <atomic>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using std::chrono::milliseconds;

TEST(FairMutex, WhoWaitsGetsItBeforeWhoComesBack) {
  FairMutex mutex;
  mutex.lock();
  std::atomic<bool> had_it{false};
  std::thread waiter([&] {
    mutex.lock();
    had_it = true;
    mutex.unlock();
  });
  // Turn by turn without a pause, as a solver works: the waiter comes in between.
  while (!had_it) {
    mutex.unlock();
    mutex.lock();
  }
  mutex.unlock();
  waiter.join();
  EXPECT_TRUE(mutex.try_lock());
}

TEST(FairMutex, WaitingEndsWithItsTimeAndLeavesNoTrace) {
  FairMutex mutex;
  mutex.lock();
  std::thread([&] { EXPECT_FALSE(mutex.try_lock_for(milliseconds(1))); }).join();
  mutex.unlock();
  EXPECT_TRUE(mutex.try_lock());
}

TEST(FairMutex, TellsOnceWhenItIsWorthAnotherTry) {
  FairMutex mutex;
  int told = 0;
  mutex.lock();
  mutex.when_free([&] { ++told; });
  EXPECT_EQ(told, 0);
  mutex.unlock();
  EXPECT_EQ(told, 1);
  mutex.when_free([&] { ++told; });
  EXPECT_EQ(told, 2);
}

TEST(FairMutex, KeepsAllOthersOut) {
  FairMutex mutex;
  int count = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&] {
      for (int n = 0; n < 2000; ++n) {
        mutex.lock();
        ++count;
        mutex.unlock();
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(count, 16'000);
}

}  // namespace
}  // namespace burnish
