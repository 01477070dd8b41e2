#pragma once

#include <atomic>
#include <chrono>
#include <string_view>

#include "common/base/progress.h"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace burnish {

/// Reports from within a parallel loop: the thread that started it reports now and then, and all
/// threads hear a cancel. Thread-safe.
class LoopProgress {
 public:
  /// `begin` to `end`: the part of the phase that the loop is. Needs: the arguments outlive it.
  LoopProgress(const Progress& progress, std::string_view phase, double begin, double end)
      : progress_(progress), phase_(phase), begin_(begin), size_(end - begin) {}

  /// Call it at least each millisecond. Returns false once the work is cancelled. `part` of the
  /// loop is done, 0 to 1.
  bool goes_on(double part) {
    if (is_first_thread()) ask(part);
    return !is_cancelled();
  }

  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
  static bool is_first_thread() {
#ifdef _OPENMP
    return omp_get_thread_num() == 0;
#else
    return true;
#endif
  }

  static constexpr std::chrono::milliseconds kInterval{50};

  void ask(double part) {
    const auto now = std::chrono::steady_clock::now();
    if (is_cancelled() || now < next_) return;
    next_ = now + kInterval;
    if (!report(progress_, phase_, begin_ + part * size_)) cancelled_ = true;
  }

  const Progress& progress_;
  const std::string_view phase_;
  const double begin_, size_;
  std::chrono::steady_clock::time_point next_;  // of the first thread alone
  std::atomic<bool> cancelled_{false};
};

}  // namespace burnish
