#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace burnish {

/// Runs work that must not delay the picture. Each piece runs on its own thread; the owner's thread
/// handles its result at the next drain(). Used from one thread.
class Tasks {
 public:
  /// Runs on the owner's thread with the result. May be empty.
  using Completion = std::function<void()>;
  /// Ends soon after the token asks for it. Must not touch data of the owner's thread.
  using Work = std::function<Completion(std::stop_token)>;

  Tasks() = default;
  /// Asks all work to stop, waits for it, and drops the results.
  ~Tasks();
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  void start(Work work);

  /// Runs the completions of work that has ended.
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
