#pragma once

#include <functional>
#include <memory>

namespace burnish {

/// Threads that do the parts of one work at a time. The caller's thread is one of them.
class WorkCrew {
 public:
  /// `threads` with the caller's: 0 takes one for each core, and 1 starts none.
  explicit WorkCrew(int threads);
  ~WorkCrew();
  WorkCrew(const WorkCrew&) = delete;
  WorkCrew& operator=(const WorkCrew&) = delete;

  int threads() const { return threads_; }

  /// Calls work(0) to work(parts - 1), each once and in any order, and returns after the last.
  /// Needs: work() throws nothing.
  void run(int parts, const std::function<void(int part)>& work);

  /// Returns how long all threads together have worked in run(), in seconds of processors: what
  /// else the machine does is not in it.
  double seconds() const { return seconds_; }

 private:
  struct Others;
  int threads_;
  double seconds_ = 0;
  std::unique_ptr<Others> others_;  // null without any
};

}  // namespace burnish
