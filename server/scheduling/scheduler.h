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

/// Something that works in turns: a session whose surface moves.
class Scheduled {
 public:
  virtual ~Scheduled() = default;

  /// Does one turn, about as long as a frame. Returns whether there is more to do. Never called by
  /// two threads at once.
  virtual bool turn() = 0;

 private:
  friend class Scheduler;
  enum class State { kIdle, kReady, kRunning, kWokenWhileRunning };
  // For the scheduler that it is woken by, under its lock.
  State state_ = State::kIdle;
  double deficit_ms_ = 0;
};

/// Chooses the next turn: deficit round robin by measured milliseconds among those with work. A
/// large session and a small one get the same time, not the same number of turns. Without work they
/// cost nothing. Thread-safe.
class Scheduler {
 public:
  using ClockMs = std::function<double()>;

  /// Takes one thread for each device that solves: all cores of the CPU are one device. With 0
  /// threads only run_one() works, for tests; these bring their clock too.
  explicit Scheduler(int threads, ClockMs clock = {});

  /// Ends after the running turns; the others are not taken.
  ~Scheduler();

  /// Says that there is work. Harmless if it is known already.
  void wake(const std::shared_ptr<Scheduled>& scheduled);

  /// Returns how many wait for a turn.
  size_t waiting() const;

  /// For work that is not scheduled, from time to time: waits while others have turns to take, but
  /// at most `time_max`.
  void give_way(std::chrono::duration<double> time_max);

  /// Takes one turn in the calling thread. Returns false if nobody has work.
  bool run_one();

  static constexpr double kQuantumMs = 5;

 private:
  std::shared_ptr<Scheduled> next();  // needs the lock and somebody who waits
  void take_turn(std::unique_lock<std::mutex>& lock);
  void run();

  const ClockMs clock_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable calm_;  // nobody waits or works
  size_t running_ = 0;
  std::deque<std::shared_ptr<Scheduled>> ring_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

/// Returns a progress that gives way to the scheduler's work: between two reports it waits for that
/// work, but no longer than its own work took.
Progress give_way_to(Scheduler& scheduler, Progress progress);

}  // namespace burnish
