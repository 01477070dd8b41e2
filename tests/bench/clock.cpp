#include "tests/bench/clock.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>

namespace burnish {

double core_gigahertz() {
  constexpr int64_t kAdditions = int64_t{1} << 22;
  double slowest = std::numeric_limits<double>::max();
#pragma omp parallel reduction(min : slowest)
  {
    const auto start = std::chrono::steady_clock::now();
    uint64_t sum = 0;
#pragma GCC unroll 8
    for (int64_t i = 0; i < kAdditions; ++i) {
      ++sum;
      asm volatile("" : "+r"(sum));  // keeps the compiler from knowing the sum
    }
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    slowest = std::min(slowest, kAdditions / time.count());
  }
  return slowest;
}

}  // namespace burnish
