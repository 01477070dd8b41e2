#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace burnish::cpu {

/// Sums over [0, n) in blocks of fixed size, the blocks in order: the same bits for any number of
/// threads. `sum_block(begin, end)` returns the sum of a block; Sum has += and a zero default.
template <typename Sum, typename SumBlock>
Sum ordered_sum(int32_t n, SumBlock&& sum_block) {
  constexpr int32_t kBlock = 2048;
  const int32_t blocks = (n + kBlock - 1) / kBlock;
  std::vector<Sum> partial(blocks);
#pragma omp parallel for schedule(static)
  for (int32_t block = 0; block < blocks; ++block)
    partial[block] = sum_block(block * kBlock, std::min(n, (block + 1) * kBlock));
  Sum total{};
  for (const Sum& sum : partial) total += sum;
  return total;
}

}  // namespace burnish::cpu
