#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "client/surface/desk.h"

namespace burnish {

/// Turns jobs into results on a thread of its own, in the order in which they come.
template <typename Job, typename Done>
class DeskThread final : public Desk<Job, Done> {
 public:
  /// `on_news`: take() has something; called from the thread.
  DeskThread(std::function<Done(const Job&)> work, std::function<void()> on_news)
      : work_(std::move(work)),
        on_news_(std::move(on_news)),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

  void put(Job job) override {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
    changed_.notify_one();
  }

  std::vector<Done> take() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, {});
  }

 private:
  void run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) {
      const Job job = std::move(jobs_.front());
      jobs_.pop_front();
      lock.unlock();
      Done done = work_(job);
      lock.lock();
      done_.push_back(std::move(done));
      lock.unlock();
      on_news_();
      lock.lock();
    }
  }

  const std::function<Done(const Job&)> work_;
  const std::function<void()> on_news_;

  std::mutex mutex_;  // guards the following members
  std::condition_variable_any changed_;
  std::deque<Job> jobs_;
  std::vector<Done> done_;

  std::jthread thread_;  // last member: it uses all the others
};

}  // namespace burnish
