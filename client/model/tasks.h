#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace burnish {

/// Work that must not hold up the picture: each piece runs on a thread of its own, and what it
/// found is handled by the owner's thread at its next drain(). Used from one thread.
class Tasks {
 public:
  /// What the owner's thread does with the outcome. May be empty.
  using Completion = std::function<void()>;
  /// Ends soon once the token says so. Must not touch what the owner's thread uses.
  using Work = std::function<Completion(std::stop_token)>;

  Tasks() = default;
  /// Asks all to stop and waits for them; their outcomes are dropped.
  ~Tasks();
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  void start(Work work);

  /// Runs the completions of what has ended.
  void drain();

  bool is_idle() const { return running_.empty(); }

 private:
  struct Running {
    std::atomic<bool> ended{false};
    Completion completion;
    std::jthread thread;
  };
  std::list<Running> running_;
};

}  // namespace burnish
