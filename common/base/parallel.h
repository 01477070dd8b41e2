#pragma once

#include <algorithm>

#ifdef _OPENMP
#include <omp.h>

#include <parallel/algorithm>
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

/// Sorts by a strict total order, so that the result does not depend on the number of threads.
template <typename Iterator, typename Less>
void parallel_sort(Iterator begin, Iterator end, Less less) {
#ifdef _OPENMP
  __gnu_parallel::sort(begin, end, less);
#else
  std::sort(begin, end, less);
#endif
}

}  // namespace burnish
