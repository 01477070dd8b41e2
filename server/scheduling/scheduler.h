#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "common/base/progress.h"

namespace burnish {

/// Something that works in turns: a session whose surface is on its way.
class Scheduled {
 public:
  virtual ~Scheduled() = default;

  /// One turn, of a frame's length or so. Returns whether there is more to do; never called by two
  /// threads at once.
  virtual bool turn() = 0;

 private:
  friend class Scheduler;
  enum class State { kIdle, kReady, kRunning, kWokenWhileRunning };
  // Of the scheduler that it is woken by, under its lock.
  State state_ = State::kIdle;
  double deficit_ms_ = 0;
};

/// Whose turn is next: deficit round robin by measured milliseconds among those that have work, so
/// that a large session and a small one get the same time, not the same number of turns. Who has
/// no work costs nothing. Thread-safe.
class Scheduler {
 public:
  using ClockMs = std::function<double()>;

  /// One thread for each device that solves: the CPU's cores together are one.
  /// With 0 threads nothing happens but by run_one(), for tests; they bring their clock as well.
  explicit Scheduler(int threads, ClockMs clock = {});

  /// Ends after the turns under way; the others are not taken.
  ~Scheduler();

  /// There is work. Harmless when it is known already.
  void wake(const std::shared_ptr<Scheduled>& scheduled);

  /// How many wait for a turn.
  size_t waiting() const;

  /// For work that is not scheduled, from time to time: waits while others have turns to take, but
  /// no longer than that.
  void give_way(std::chrono::duration<double> time_max);

  /// Takes one turn in the calling thread; false when nobody has work.
  bool run_one();

  static constexpr double kQuantumMs = 5;

 private:
  std::shared_ptr<Scheduled> next();  // needs the lock and somebody who waits
  void take_turn(std::unique_lock<std::mutex>& lock);
  void run();

  const ClockMs clock_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable calm_;  // nobody waits, nobody is at it
  size_t running_ = 0;
  std::deque<std::shared_ptr<Scheduled>> ring_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

/// The progress of work that gives way to the scheduler's: between two reports it waits for that,
/// but no longer than it has worked itself.
Progress give_way_to(Scheduler& scheduler, Progress progress);

}  // namespace burnish
