#pragma once

#include <algorithm>
#include <atomic>
#include <exception>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace burnish {

/// Sets how many threads the next parallel loops of the calling thread use; 0 changes nothing.
inline void use_threads(int threads) {
#ifdef _OPENMP
  if (threads > 0) omp_set_num_threads(threads);
#else
  (void)threads;
#endif
}

/// Returns how many threads a parallel loop would use now.
inline int thread_count() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

/// Carries an exception out of a parallel region, where it would end the process. A loop whose body
/// allocates memory calls run() for each turn: run() keeps the first exception and skips the later
/// turns. After the region the loop calls rethrow().
class ParallelFailure {
 public:
  template <typename Body>
  void run(Body&& body) noexcept {
    if (failed_.load(std::memory_order_relaxed)) return;
#ifdef __cpp_exceptions
    try {
      body();
    } catch (...) {
      if (!failed_.exchange(true)) first_ = std::current_exception();
    }
#else
    body();  // without memory the program ends
#endif
  }

  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::atomic<bool> failed_{false};
  std::exception_ptr first_;
};

/// Sorts by a strict total order, so the result does not depend on the number of threads. Never
/// fails: without memory for a merge buffer it merges in place.
template <typename Iterator, typename Less>
void parallel_sort(Iterator begin, Iterator end, Less less) {
  constexpr int kPieces = 16;
  constexpr auto kAlone = 4096;  // for fewer elements, waking threads takes longer
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
