#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "server/solver/hierarchy/stencil.h"

namespace burnish::cpu {

/// Calls store(corner, first entry's place in the stencil, entries, row sum) for the irregular row
/// `i`. Makes the row from a depth's numbers. Numbers from `number_count` on are zero.
template <typename T, typename Store>
void sum_irregular_row(const Stencil& stencil, int64_t i, const T* numbers, size_t number_count,
                       Store&& store) {
  const IrregularRows& rows = stencil.irregular;
  std::vector<T> sums;
  for (int64_t s = rows.sum_start[i]; s < rows.sum_start[i + 1]; ++s) {
    T sum = 0;
    for (int64_t k = rows.source_start[s]; k < rows.source_start[s + 1]; ++k)
      if (static_cast<size_t>(rows.source[k]) < number_count) sum += numbers[rows.source[k]];
    sums.push_back(sum);
  }
  const std::span<const T> entries(sums.data(), sums.size() - 1);
  store(rows.corner[i], stencil.row(rows.corner[i]).begin, entries, sums.back());
}

/// Does so for every irregular row.
template <typename T, typename Store>
void sum_irregular_rows(const Stencil& stencil, const T* numbers, size_t number_count,
                        Store&& store) {
  // For fewer, waking threads takes longer. Without OpenMP nothing uses it.
  [[maybe_unused]] constexpr int32_t kRowsAlone = 128;
  const int32_t count = stencil.irregular.count();
#pragma omp parallel for schedule(dynamic, 64) if (count > kRowsAlone)
  for (int32_t i = 0; i < count; ++i) sum_irregular_row(stencil, i, numbers, number_count, store);
}

/// Does so for the irregular rows of some corners; passes over regular ones.
template <typename T, typename Store>
void sum_irregular_rows(const Stencil& stencil, std::span<const int32_t> corners, const T* numbers,
                        size_t number_count, Store&& store) {
  const std::vector<int32_t>& irregular = stencil.irregular.corner;
#pragma omp parallel for schedule(dynamic, 256)
  for (const int32_t corner : corners)
    if (stencil.is_irregular(corner))
      sum_irregular_row(stencil, std::ranges::lower_bound(irregular, corner) - irregular.begin(),
                        numbers, number_count, store);
}

}  // namespace burnish::cpu
