#pragma once

#include <algorithm>
#include <cstdint>

#include "common/base/heard_loop.h"
#include "common/base/parallel.h"
#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

/// Runs work on many pages by all threads, and hears a cancel between two pages of a thread.
class PageWork {
 public:
  static constexpr size_t kPagesPerBatch = 256;

  PageWork(const Progress& progress, double done, double done_at_end)
      : progress_(progress), done_(done), done_at_end_(done_at_end) {}

  /// Calls make(page) for all pages on any thread, then after each batch take(page) in their order
  /// on this one. `take` returns a Status.
  /// Fails: cancelled; what `take` says. Throws: what `make` throws.
  template <typename Make, typename Take>
  Status run(size_t pages, Make&& make, Take&& take) const {
    LoopProgress loop(progress_, "pages", done_, done_at_end_);
    for (size_t begin = 0; begin < pages; begin += kPagesPerBatch) {
      const size_t end = std::min(pages, begin + kPagesPerBatch);
      const double part = static_cast<double>(begin) / static_cast<double>(pages);
      ParallelFailure failure;
#pragma omp parallel for schedule(dynamic)
      for (size_t page = begin; page < end; ++page)
        if (loop.goes_on(part)) failure.run([&] { make(page); });
      failure.rethrow();
      if (loop.is_cancelled()) return cancelled("cancelled while making pages");
      for (size_t page = begin; page < end; ++page) RETURN_IF_ERROR(take(page));
      const double done = static_cast<double>(end) / static_cast<double>(pages);
      if (!report(progress_, "pages", done_ + (done_at_end_ - done_) * done))
        return cancelled("cancelled while making pages");
    }
    return Status::ok();
  }

  /// Returns the part for work behind the pages.
  LoopPart end() const {
    return {progress_, "pages", done_at_end_, done_at_end_};
  }

  template <typename Make>
  Status run(size_t pages, Make&& make) const {
    return run(pages, make, [](size_t) { return Status::ok(); });
  }

 private:
  const Progress& progress_;
  double done_, done_at_end_;
};

}  // namespace burnish
