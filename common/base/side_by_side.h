#pragma once

#include <algorithm>
#include <future>
#include <vector>

#include "common/base/parallel.h"

namespace burnish {

/// Calls work(0) to work(count - 1) at the same time, each in a thread of its own whose parallel
/// loops have its part of the caller's threads: for work of which much is for one thread. Throws
/// what work throws.
template <typename Work>
void run_side_by_side(int count, const Work& work) {
  const int threads = std::max(1, thread_count() / std::max(1, count));
  std::vector<std::future<void>> running;
  for (int i = 0; i < count; ++i)
    running.push_back(std::async(std::launch::async, [&work, i, threads] {
      use_threads(threads);
      work(i);
    }));
  for (std::future<void>& one : running) one.get();
}

}  // namespace burnish
