#include "client/raster/work_crew.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace burnish {

// Returns how long the calling thread has run.
static double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

static int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

/// The threads besides the caller's, and the work that they share with it.
struct WorkCrew::Others {
  std::mutex mutex;
  std::condition_variable changed;
  const std::function<void(int)>* work = nullptr;
  int parts = 0;
  uint64_t round = 0;  // of works, counted
  int busy = 0;
  double seconds = 0;  // of this work, by threads that have ended it
  bool is_over = false;
  std::atomic<int> next = 0;
  std::vector<std::jthread> threads;  // last: they use all of the above

  ~Others() {
    {
      const std::lock_guard lock(mutex);
      is_over = true;
    }
    changed.notify_all();
    threads.clear();
  }

  /// Returns how long the parts of this thread took.
  double take_parts() {
    const double begin = processor_seconds();
    for (int part = next++; part < parts; part = next++) (*work)(part);
    return processor_seconds() - begin;
  }

  void serve() {
    uint64_t seen = 0;
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return is_over || round != seen; });
      if (is_over) return;
      seen = round;
      lock.unlock();
      const double took = take_parts();
      lock.lock();
      seconds += took;
      if (--busy == 0) changed.notify_all();
    }
  }
};

WorkCrew::WorkCrew(int threads) : threads_(thread_count(threads)) {
  if (threads_ == 1) return;
  others_ = std::make_unique<Others>();
  for (int i = 1; i < threads_; ++i) others_->threads.emplace_back([this] { others_->serve(); });
}

WorkCrew::~WorkCrew() = default;

void WorkCrew::run(int parts, const std::function<void(int)>& work) {
  if (!others_) {
    const double begin = processor_seconds();
    for (int part = 0; part < parts; ++part) work(part);
    seconds_ += processor_seconds() - begin;
    return;
  }
  std::unique_lock lock(others_->mutex);
  others_->work = &work;
  others_->parts = parts;
  others_->next = 0;
  others_->busy = threads_ - 1;
  ++others_->round;
  lock.unlock();
  others_->changed.notify_all();
  const double took = others_->take_parts();
  lock.lock();
  others_->changed.wait(lock, [this] { return others_->busy == 0; });
  seconds_ += took + std::exchange(others_->seconds, 0);
}

}  // namespace burnish
