#include "server/scheduling/fair_mutex.h"

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(FairMutex, WhoWaitsGetsItBeforeWhoComesBack) {
  FairMutex mutex;
  mutex.lock();
  std::atomic<bool> had_it{false};
  std::thread waiter([&] {
    mutex.lock();
    had_it = true;
    mutex.unlock();
  });
  // Works turn by turn without a pause, like a solver: the waiter must get in between.
  while (!had_it) {
    mutex.unlock();
    mutex.lock();
  }
  mutex.unlock();
  waiter.join();
  EXPECT_TRUE(mutex.try_lock());
}

TEST(FairMutex, WaitingEndsWhenItIsToldAndLeavesNoTrace) {
  FairMutex mutex;
  mutex.lock();
  std::thread([&] { EXPECT_FALSE(mutex.lock_while([] { return false; })); }).join();
  mutex.unlock();
  EXPECT_TRUE(mutex.try_lock());
}

/// Waits in a thread, and says when it waits.
class InLine {
 public:
  InLine(FairMutex& mutex, std::function<void()> work)
      : thread_([this, &mutex, work = std::move(work)] {
          const bool got = mutex.lock_while([this] {
            waits_ = true;  // first called after a while in the line
            return true;
          });
          EXPECT_TRUE(got);
          work();
          mutex.unlock();
        }) {
    while (!waits_) std::this_thread::yield();
  }
  ~InLine() { thread_.join(); }

 private:
  std::atomic<bool> waits_{false};
  std::thread thread_;
};

TEST(FairMutex, WhoAsksAgainAndAgainKeepsItsPlace) {
  FairMutex mutex;
  std::string order;
  mutex.lock();
  {
    InLine first(mutex, [&] { order += 'a'; });
    InLine second(mutex, [&] { order += 'b'; });
    mutex.unlock();
  }
  EXPECT_EQ(order, "ab");
}

TEST(FairMutex, ATicketIsCalledOnceAndTheMutexIsKeptForIt) {
  FairMutex mutex;
  int calls = 0;
  FairMutex::Ticket ticket(mutex, [&] { ++calls; });
  mutex.lock();
  EXPECT_FALSE(ticket.take());
  EXPECT_FALSE(ticket.take());
  EXPECT_EQ(calls, 0);
  mutex.unlock();
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(mutex.try_lock());
  EXPECT_TRUE(ticket.take());
  mutex.unlock();
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(mutex.try_lock());
}

TEST(FairMutex, AFreeOneIsTakenAtOnce) {
  FairMutex mutex;
  FairMutex::Ticket ticket(mutex, [] { ADD_FAILURE() << "called for nothing"; });
  EXPECT_TRUE(ticket.take());
  EXPECT_FALSE(mutex.try_lock());
  mutex.unlock();
}

TEST(FairMutex, ATicketComesBeforeAllButOneOfThoseWhoWait) {
  FairMutex mutex;
  std::string order;
  FairMutex::Ticket ticket(mutex, [] {});
  mutex.lock();
  {
    InLine first(mutex, [&] {
      order += 'a';
      EXPECT_FALSE(ticket.take());
    });
    InLine second(mutex, [&] { order += 'b'; });
    EXPECT_FALSE(ticket.take());
    mutex.unlock();
    for (int turn = 0; turn < 2; ++turn) {
      while (!ticket.take()) std::this_thread::yield();
      order += 'p';
      mutex.unlock();
    }
  }
  EXPECT_EQ(order, "papb");
}

TEST(FairMutex, ATicketThatLeavesOrEndsHandsOn) {
  FairMutex mutex;
  bool had_it = false;
  {
    FairMutex::Ticket ticket(mutex, [] {});
    mutex.lock();
    EXPECT_FALSE(ticket.take());
    InLine waiter(mutex, [&] { had_it = true; });
    mutex.unlock();
    ticket.leave();
  }
  EXPECT_TRUE(had_it);
  {
    FairMutex::Ticket ticket(mutex, [] {});
    mutex.lock();
    EXPECT_FALSE(ticket.take());
    mutex.unlock();
  }
  EXPECT_TRUE(mutex.try_lock());
}

TEST(FairMutex, ALongHolderLetsATicketPassAndNobodyElse) {
  FairMutex mutex;
  std::string order;
  std::atomic<bool> called{false};
  FairMutex::Ticket ticket(mutex, [&] { called = true; });
  mutex.lock();
  mutex.let_ticket_pass();
  EXPECT_FALSE(ticket.take());
  {
    InLine waiter(mutex, [&] { order += 'w'; });
    std::thread turn([&] {
      while (!called) std::this_thread::yield();
      EXPECT_TRUE(ticket.take());
      order += 'p';
      mutex.unlock();
    });
    mutex.let_ticket_pass();
    order += 'h';
    turn.join();
    mutex.unlock();
  }
  EXPECT_EQ(order, "phw");
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
