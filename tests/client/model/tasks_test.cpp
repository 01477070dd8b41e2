#include "client/model/tasks/tasks.h"

#include <latch>
#include <thread>

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Tasks, WorkRunsElsewhereAndItsCompletionHere) {
  Tasks tasks;
  std::thread::id worked, completed;
  tasks.start([&](StopToken) -> Tasks::Completion {
    worked = std::this_thread::get_id();
    return [&] { completed = std::this_thread::get_id(); };
  });
  while (!tasks.is_idle()) tasks.drain();
  EXPECT_EQ(completed, std::this_thread::get_id());
  EXPECT_NE(worked, completed);
}

// The owner looks while the work's thread still tells it.
TEST(Tasks, WhoDrainsOnlyWhenToldHandlesTheResult) {
  constexpr int kYields = 1000;
  std::latch told(1);
  Tasks tasks([&] {
    told.count_down();
    for (int i = 0; i < kYields; ++i) std::this_thread::yield();
  });
  bool is_handled = false;
  tasks.start([&](StopToken) -> Tasks::Completion { return [&] { is_handled = true; }; });
  told.wait();
  tasks.drain();
  EXPECT_TRUE(is_handled);
}

TEST(Tasks, ACompletionMayStartMore) {
  Tasks tasks;
  int done = 0;
  tasks.start([&](StopToken) -> Tasks::Completion {
    return [&] {
      ++done;
      tasks.start([&](StopToken) -> Tasks::Completion { return [&] { ++done; }; });
    };
  });
  while (!tasks.is_idle()) tasks.drain();
  EXPECT_EQ(done, 2);
}

TEST(Tasks, TheEndAsksWorkToStopAndDropsItsOutcome) {
  bool completed = false, stopped = false;
  {
    std::latch begun(1);
    Tasks tasks;
    tasks.start([&](const StopToken& stop) -> Tasks::Completion {
      begun.count_down();
      while (!stop.stop_requested()) std::this_thread::yield();
      stopped = true;
      return [&] { completed = true; };
    });
    begun.wait();
  }
  EXPECT_TRUE(stopped);
  EXPECT_FALSE(completed);
}

}  // namespace
}  // namespace burnish
