#pragma once

#include <algorithm>
#include <atomic>
#include <exception>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace burnish {

/// How many threads the calling thread's next parallel loops use; 0 leaves it as it is.
inline void use_threads(int threads) {
#ifdef _OPENMP
  if (threads > 0) omp_set_num_threads(threads);
#else
  (void)threads;
#endif
}

/// How many threads a parallel loop would use now.
inline int thread_count() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

/// An exception that leaves a parallel region ends the process. A loop whose body takes memory runs
/// each turn by run(), which keeps the first exception and skips what follows, and calls rethrow()
/// behind the region.
class ParallelFailure {
 public:
  template <typename Body>
  void run(Body&& body) noexcept {
    if (failed_.load(std::memory_order_relaxed)) return;
    try {
      body();
    } catch (...) {
      if (!failed_.exchange(true)) first_ = std::current_exception();
    }
  }

  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::atomic<bool> failed_{false};
  std::exception_ptr first_;
};

/// Sorts by a strict total order, so that the result does not depend on the number of threads.
/// Never fails: where there is no memory for merging beside the elements it is done in their place.
template <typename Iterator, typename Less>
void parallel_sort(Iterator begin, Iterator end, Less less) {
  constexpr int kPieces = 16;
  constexpr auto kAlone = 4096;  // for fewer, threads take longer to wake
  const auto size = end - begin;
  if (size < kAlone || thread_count() == 1) return std::sort(begin, end, less);
  const auto start = [&](int piece) { return begin + size * piece / kPieces; };
#pragma omp parallel for schedule(dynamic)
  for (int piece = 0; piece < kPieces; ++piece) std::sort(start(piece), start(piece + 1), less);
  for (int width = 1; width < kPieces; width *= 2) {
#pragma omp parallel for schedule(dynamic)
    for (int piece = 0; piece < kPieces; piece += 2 * width)
      std::inplace_merge(start(piece), start(piece + width), start(piece + 2 * width), less);
  }
}

}  // namespace burnish
