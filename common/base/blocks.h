#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace burnish {

/// Loops work through items in blocks of this many: whole tiles of a stencil's rows, if they are
/// corners.
inline constexpr int32_t kBlock = 2048;

/// Runs `run_block(begin, end)` over [0, n), blocks in parallel. Each block goes to a free thread,
/// so that other work on a core does not make all threads wait.
template <typename RunBlock>
void for_each_block(int32_t n, RunBlock&& run_block) {
#pragma omp parallel for schedule(dynamic) if (n > kBlock)
  for (int32_t begin = 0; begin < n; begin += kBlock) run_block(begin, std::min(n, begin + kBlock));
}

/// Sums over [0, n) in blocks, and the blocks in order: the same bits for any number of threads.
/// `sum_block(begin, end)` returns the sum of a block; Sum has += and a zero default.
template <typename Sum, typename SumBlock>
Sum ordered_sum(int32_t n, SumBlock&& sum_block) {
  std::vector<Sum> partial((n + kBlock - 1) / kBlock);
  for_each_block(
      n, [&](int32_t begin, int32_t end) { partial[begin / kBlock] = sum_block(begin, end); });
  Sum total{};
  for (const Sum& sum : partial) total += sum;
  return total;
}

}  // namespace burnish
