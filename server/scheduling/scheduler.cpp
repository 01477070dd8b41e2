#include "server/scheduling/scheduler.h"

#include <algorithm>
#include <chrono>

namespace burnish {

static double steady_ms() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

Scheduler::Scheduler(int threads, ClockMs clock) : clock_(clock ? std::move(clock) : steady_ms) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

Scheduler::~Scheduler() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Scheduler::wake(const std::shared_ptr<Scheduled>& scheduled) {
  using State = Scheduled::State;
  {
    const std::lock_guard lock(mutex_);
    State& state = scheduled->state_;
    if (state == State::kRunning) state = State::kWokenWhileRunning;
    if (state != State::kIdle) return;
    state = State::kReady;
    ring_.push_back(scheduled);
  }
  wake_.notify_one();
}

size_t Scheduler::waiting() const {
  const std::lock_guard lock(mutex_);
  return ring_.size();
}

void Scheduler::give_way(std::chrono::duration<double> time_max) {
  std::unique_lock lock(mutex_);
  calm_.wait_for(lock, time_max, [this] { return ring_.empty() && running_ == 0; });
}

Progress give_way_to(Scheduler& scheduler, Progress progress) {
  using std::chrono::steady_clock;
  return [&scheduler, progress = std::move(progress), last = steady_clock::now()](
             std::string_view phase, double fraction) mutable {
    scheduler.give_way(steady_clock::now() - last);
    last = steady_clock::now();
    return report(progress, phase, fraction);
  };
}

bool Scheduler::run_one() {
  std::unique_lock lock(mutex_);
  if (ring_.empty()) return false;
  take_turn(lock);
  return true;
}

// The first one gets some time if it has none left. One that is still in debt goes to the end.
std::shared_ptr<Scheduled> Scheduler::next() {
  for (;;) {
    double& deficit_ms = ring_.front()->deficit_ms_;
    if (deficit_ms <= 0) deficit_ms += kQuantumMs;
    if (deficit_ms > 0) break;
    std::rotate(ring_.begin(), ring_.begin() + 1, ring_.end());
  }
  std::shared_ptr<Scheduled> first = std::move(ring_.front());
  ring_.pop_front();
  return first;
}

void Scheduler::take_turn(std::unique_lock<std::mutex>& lock) {
  using State = Scheduled::State;
  std::shared_ptr<Scheduled> scheduled = next();
  scheduled->state_ = State::kRunning;
  ++running_;
  lock.unlock();
  const double start = clock_();
  const bool has_more = scheduled->turn();
  const double cost = clock_() - start;
  lock.lock();
  --running_;
  scheduled->deficit_ms_ -= cost;
  if (has_more || scheduled->state_ == State::kWokenWhileRunning) {
    scheduled->state_ = State::kReady;
    // With time left it goes on; else the others come first.
    if (scheduled->deficit_ms_ > 0) {
      ring_.push_front(scheduled);
    } else {
      ring_.push_back(scheduled);
    }
    return;
  }
  scheduled->state_ = State::kIdle;
  // Unused time is lost, but overdrawn time stays owed.
  scheduled->deficit_ms_ = std::min(scheduled->deficit_ms_, 0.0);
  if (ring_.empty() && running_ == 0) calm_.notify_all();
  lock.unlock();  // the object may end here
  scheduled.reset();
  lock.lock();
}

void Scheduler::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return ending_ || !ring_.empty(); });
    if (ending_) return;
    take_turn(lock);
  }
}

}  // namespace burnish
