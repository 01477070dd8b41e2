#pragma once

#include "tests/bench/timing.h"

namespace burnish::bench {

/// Returns whether to measure again for a median: three times in all, but only once if it takes
/// seconds.
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
