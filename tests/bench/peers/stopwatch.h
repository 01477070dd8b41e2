#pragma once

#include "tests/bench/timing.h"

namespace burnish::bench {

/// Whether to measure once more for a median: thrice in all, but what takes seconds only once.
inline bool wants_another(size_t measured, double last_ms) {
  return measured < 3 && last_ms < 1000;
}

template <typename Work>
double median_milliseconds(Work&& work) {
  std::vector<double> times;
  do {
    times.push_back(milliseconds(work));
  } while (wants_another(times.size(), times.back()));
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

}  // namespace burnish::bench
