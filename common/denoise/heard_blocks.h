#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <vector>

#include "common/base/heard_loop.h"

namespace burnish {

/// Calls visit(begin, end) for blocks of 0 to `count` by all threads. A visit throws nothing.
/// Throws: WorkCancelled.
template <typename Visit>
void for_each_block_heard(const LoopPart& part, size_t count, const Visit& visit) {
  LoopProgress loop(part.progress, part.phase, part.begin, part.end);
  std::atomic<size_t> done{0};
  ask_before(loop);
#pragma omp parallel for schedule(dynamic)
  for (size_t begin = 0; begin < count; begin += kHeardBlock) {
    if (!loop.goes_on(static_cast<double>(done) / static_cast<double>(count))) continue;
    const size_t end = std::min(count, begin + kHeardBlock);
    visit(begin, end);
    done += end - begin;
  }
  leave_if_cancelled(loop);
}

/// Returns the part of a pass, from 0 on, of `passes`.
inline LoopPart part_of_pass(const LoopPart& part, int pass, int passes) {
  return part.of(static_cast<double>(pass) / passes, static_cast<double>(pass + 1) / passes);
}

/// Returns the sum of value(i) for 0 to `count`: the same bits for any number of threads. Throws:
/// WorkCancelled.
template <typename Value>
double heard_sum(const LoopPart& part, size_t count, const Value& value) {
  std::vector<double> partial(count / kHeardBlock + 1, 0);
  for_each_block_heard(part, count, [&](size_t begin, size_t end) {
    double sum = 0;
    for (size_t i = begin; i < end; ++i) sum += value(i);
    partial[begin / kHeardBlock] = sum;
  });
  double total = 0;
  for (const double sum : partial) total += sum;
  return total;
}

}  // namespace burnish
