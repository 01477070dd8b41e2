#include "tests/bench/triad.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace burnish {

double triad_gigabytes_per_second() {
  constexpr int64_t kCount = int64_t{1} << 25;
  constexpr int kRepeats = 7;
  std::vector<double> a(kCount, 0), b(kCount, 1), c(kCount, 2);
  double best = 0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const auto start = std::chrono::steady_clock::now();
#pragma omp parallel for schedule(static)
    for (int64_t i = 0; i < kCount; ++i) a[i] = b[i] + 3.0 * c[i];
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    best = std::max(best, 3.0 * sizeof(double) * kCount / seconds.count() * 1e-9);
  }
  return best;
}

}  // namespace burnish
