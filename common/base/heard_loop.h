#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "common/base/loop_progress.h"
#include "common/base/progress.h"

namespace burnish {

// Long loops of functions that return values. They report, and leave with WorkCancelled once
// somebody cancels. Nobody waits longer than for one block of each thread.

/// Thrown when long work is cancelled. It is caught before an interface.
class WorkCancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "the work was cancelled"; }
};

/// Leaves cancelled work. A program without exceptions cancels nothing.
[[noreturn]] inline void leave_cancelled_work() {
#ifdef __cpp_exceptions
  throw WorkCancelled();
#else
  std::abort();
#endif
}

/// The listener of a loop, and the part of a phase that the loop is.
struct LoopPart {
  const Progress& progress;
  std::string_view phase;
  double begin = 0;
  double end = 1;

  /// Returns a part of this part; both numbers are in [0, 1].
  LoopPart of(double from, double to) const {
    return {progress, phase, begin + from * (end - begin), begin + to * (end - begin)};
  }
};

inline const Progress kNoProgress;
inline constexpr LoopPart kUnheardLoop = {kNoProgress, {}};
inline constexpr size_t kHeardBlock = 2048;  // a fraction of a millisecond

/// Asks before a loop of all threads, whose blocks may all go to others than the first one.
inline void ask_before(LoopProgress& loop) {
  if (!loop.goes_on(0)) leave_cancelled_work();
}

inline void leave_if_cancelled(const LoopProgress& loop) {
  if (loop.is_cancelled()) leave_cancelled_work();
}

/// Calls visit(i) for 0 to `count`, in this order and on the calling thread.
template <typename Visit>
void for_each_heard(const LoopPart& part, size_t count, const Visit& visit) {
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
  const auto all = static_cast<double>(count);
  for (size_t begin = 0; begin < count; begin += kHeardBlock) {
    if (!loop.goes_on(static_cast<double>(begin) / all)) leave_cancelled_work();
    const size_t end = std::min(count, begin + kHeardBlock);
    for (size_t i = begin; i < end; ++i) visit(i);
  }
}

/// Calls visit(i) for 0 to `count` by all threads. A visit throws nothing.
template <typename Visit>
void parallel_for_heard(const LoopPart& part, size_t count, const Visit& visit) {
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
  const auto all = static_cast<double>(count);
  std::atomic<size_t> done{0};
  ask_before(loop);
#pragma omp parallel for schedule(dynamic)
  for (size_t begin = 0; begin < count; begin += kHeardBlock) {
    if (!loop.goes_on(static_cast<double>(done) / all)) continue;
    const size_t end = std::min(count, begin + kHeardBlock);
    for (size_t i = begin; i < end; ++i) visit(i);
    done += end - begin;
  }
  leave_if_cancelled(loop);
}

/// Sorts by a strict order on the calling thread.
template <typename Iterator, typename Less>
void sort_heard(const LoopPart& part, Iterator begin, Iterator end, const Less& less) {
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
  size_t left = kHeardBlock;
  std::sort(begin, end, [&](const auto& a, const auto& b) {
    if (--left == 0) {
      left = kHeardBlock;
      if (!loop.goes_on(0)) leave_cancelled_work();
    }
    return less(a, b);
  });
}

}  // namespace burnish
