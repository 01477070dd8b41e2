#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace burnish::bench {

template <typename Work>
double milliseconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

template <typename Work>
double median_milliseconds(int repeats, Work&& work) {
  std::vector<double> times(static_cast<size_t>(repeats));
  for (double& time : times) time = milliseconds(work);
  std::nth_element(times.begin(), times.begin() + repeats / 2, times.end());
  return times[static_cast<size_t>(repeats) / 2];
}

}  // namespace burnish::bench
