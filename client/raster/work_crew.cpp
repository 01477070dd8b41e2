#include "client/raster/work_crew.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace burnish {

/// The threads besides the caller's, and the work that they share with it.
struct WorkCrew::Others {
  std::mutex mutex;
  std::condition_variable changed;
  const std::function<void(int)>* work = nullptr;
  int parts = 0;
  uint64_t round = 0;  // of works, counted
  int busy = 0;
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

  void take_parts() {
    for (int part = next++; part < parts; part = next++) (*work)(part);
  }

  void serve() {
    uint64_t seen = 0;
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [&] { return is_over || round != seen; });
      if (is_over) return;
      seen = round;
      lock.unlock();
      take_parts();
      lock.lock();
      if (--busy == 0) changed.notify_all();
    }
  }
};

WorkCrew::WorkCrew(int threads) : threads_(threads) {
  if (threads <= 1) return;
  others_ = std::make_unique<Others>();
  for (int i = 1; i < threads; ++i) others_->threads.emplace_back([this] { others_->serve(); });
}

WorkCrew::~WorkCrew() = default;

void WorkCrew::run(int parts, const std::function<void(int)>& work) {
  if (!others_) {
    for (int part = 0; part < parts; ++part) work(part);
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
  others_->take_parts();
  lock.lock();
  others_->changed.wait(lock, [this] { return others_->busy == 0; });
}

}  // namespace burnish
