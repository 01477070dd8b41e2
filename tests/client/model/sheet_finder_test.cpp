#include "client/model/documents/sheet_finder.h"

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace burnish {
namespace {

/// A server whose calls end when the test says so, or at the next progress once they are cancelled.
/// The version of what it finds is ten times the amount.
class FakeBakery {
 public:
  SheetFinder::Describe describe() {
    return [this](const SeamsOfSession& seams, const Progress& progress) {
      std::unique_lock lock(mutex_);
      begun_.push_back(seams.amount);
      changed_.notify_all();
      while (!is_done_[seams.amount]) {
        lock.unlock();
        const bool goes_on = progress("sheets", 0);
        lock.lock();
        if (!goes_on) return cancel();
        changed_.wait(lock, [this] { return std::exchange(has_step_, false); });
      }
      SheetsDescription found;
      found.version = static_cast<uint64_t>(10 * seams.amount);
      return Result<SheetsDescription>(found);
    };
  }

  void wait_until_cancelled() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return is_cancelled_; });
  }
  void wait_until_begun(size_t calls) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return begun_.size() == calls; });
  }
  void step() {
    const std::lock_guard lock(mutex_);
    has_step_ = true;
    changed_.notify_all();
  }
  void finish(double amount) {
    const std::lock_guard lock(mutex_);
    is_done_[amount] = has_step_ = true;
    changed_.notify_all();
  }
  std::vector<double> begun() {
    const std::lock_guard lock(mutex_);
    return begun_;
  }

 private:
  /// Needs the lock.
  Result<SheetsDescription> cancel() {
    is_cancelled_ = true;
    changed_.notify_all();
    return cancelled("the call was cancelled");
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<double, bool> is_done_;
  bool has_step_ = false, is_cancelled_ = false;
  std::vector<double> begun_;
};

class SheetFinderOfABakery : public testing::Test {
 protected:
  /// Handles what ends until so many calls have begun.
  void drain_until_begun(size_t calls) {
    while (bakery_.begun().size() < calls) tasks_.drain();
  }
  void drain_until_found() {
    while (finder_.is_finding()) tasks_.drain();
  }

  FakeBakery bakery_;
  Tasks tasks_;
  std::vector<uint64_t> versions_;
  std::vector<StatusCode> failures_;
  SheetFinder finder_{tasks_, bakery_.describe(), [this](const Result<SheetsDescription>& found) {
                        if (found.is_ok())
                          versions_.push_back(found->version);
                        else
                          failures_.push_back(found.status().code());
                      }};
};

TEST_F(SheetFinderOfABakery, ANewerWishCancelsACallWithinAStep) {
  finder_.find({0.5, {}});
  bakery_.wait_until_begun(1);
  finder_.follow({1, {}});
  bakery_.step();
  drain_until_begun(2);
  bakery_.finish(1);
  drain_until_found();
  EXPECT_EQ(versions_, std::vector<uint64_t>{10});
  EXPECT_TRUE(failures_.empty()) << "nobody failed";
  EXPECT_EQ(bakery_.begun(), (std::vector<double>{0.5, 1}));
}

TEST_F(SheetFinderOfABakery, ACallIsCancelledWhenItsFinderGoes) {
  auto finder = std::make_unique<SheetFinder>(
      tasks_, bakery_.describe(),
      [](const Result<SheetsDescription>&) { ADD_FAILURE() << "nobody waits for it"; });
  finder->find({0.5, {}});
  bakery_.wait_until_begun(1);
  finder.reset();
  bakery_.step();
  bakery_.wait_until_cancelled();
  tasks_.drain();
}

TEST_F(SheetFinderOfABakery, OnlyTheNewestOfManyWishesIsAskedFor) {
  finder_.find({0.1, {}});
  bakery_.wait_until_begun(1);
  for (const double amount : {0.2, 0.3, 0.4, 0.1}) finder_.follow({amount, {}});
  bakery_.finish(0.1);
  drain_until_found();
  EXPECT_EQ(versions_.back(), 1u);
  EXPECT_EQ(bakery_.begun(), (std::vector<double>{0.1, 0.1}));
}

TEST_F(SheetFinderOfABakery, AnotherRegionIsAnotherWish) {
  finder_.find({1, {}});
  bakery_.wait_until_begun(1);
  finder_.follow({1, {7}});
  bakery_.step();
  drain_until_begun(2);
  bakery_.finish(1);
  drain_until_found();
  EXPECT_EQ(versions_.size(), 1u);
}

TEST_F(SheetFinderOfABakery, TheSameWishLeavesACallAlone) {
  finder_.find({1, {}});
  bakery_.wait_until_begun(1);
  finder_.follow({1, {}});
  finder_.find({1, {}});
  bakery_.finish(1);
  drain_until_found();
  finder_.follow({1, {}});
  EXPECT_FALSE(finder_.is_finding());
  EXPECT_EQ(bakery_.begun().size(), 1u);
}

TEST_F(SheetFinderOfABakery, NothingIsFollowedBeforeTheFirstWish) {
  finder_.follow({1, {}});
  EXPECT_FALSE(finder_.is_finding());
}

}  // namespace
}  // namespace burnish
