#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace burnish {

/// Returns the wall time of one call.
template <typename Work>
double milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

/// Returns the upper median of `repeats` calls after `warm_up` calls that do not count.
template <typename Work>
double median_milliseconds(int repeats, int warm_up, Work&& work) {
  for (int i = 0; i < warm_up; ++i) work();
  std::vector<double> times(repeats);
  for (double& time : times) time = milliseconds(work);
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[repeats / 2];
}

}  // namespace burnish
