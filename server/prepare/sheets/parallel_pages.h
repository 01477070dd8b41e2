#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <ctime>

#include "common/base/heard_loop.h"
#include "common/base/loop_progress.h"
#include "common/base/parallel.h"

namespace burnish {

/// Calls make(page, ask) for a range of pages by all threads. `make` calls ask() often. The first
/// thread has nothing to do at the end but to hear a cancel, so that nobody waits for a page of
/// another thread. `loop` and `all`: of all pages. Throws: what `make` throws; WorkCancelled.
template <typename Make>
void parallel_pages(size_t begin, size_t end, size_t all, LoopProgress& loop, const Make& make) {
  constexpr timespec kPause{.tv_sec = 0, .tv_nsec = 5'000'000};
  std::atomic<size_t> next{begin};
  std::atomic<size_t> done{begin};
  ParallelFailure failure;
  const auto part = [&] { return static_cast<double>(done) / static_cast<double>(all); };
  const auto ask = [&] {
    if (!loop.goes_on(part())) leave_cancelled_work();
  };
  ask();
#pragma omp parallel
  {
    for (size_t page = next++; page < end; page = next++, ++done)
      failure.run([&] {
        ask();
        make(page, ask);
      });
#pragma omp master
    while (done < end && loop.goes_on(part())) nanosleep(&kPause, nullptr);
  }
  failure.rethrow();
}

}  // namespace burnish
