#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace burnish {

/// A few threads that run what must not block a reaction of the service: disk, solver, journal.
class Executor {
 public:
  explicit Executor(int threads);

  /// Runs what has been posted, then ends.
  ~Executor();

  void post(std::function<void()> work);

 private:
  void run();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> queue_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace burnish
