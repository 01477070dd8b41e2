#pragma once

#include <span>

#include "server/solver/hierarchy/stencil.h"

namespace burnish::cpu {

/// Calls store(corner, first entry's place in the stencil, entries, row sum) for every irregular
/// row. Makes the row from a depth's numbers. Numbers from `number_count` on are zero.
template <typename T, typename Store>
void sum_irregular_rows(const Stencil& stencil, const T* numbers, size_t number_count,
                        Store&& store) {
  constexpr int32_t kRowsAlone = 128;  // for fewer, waking threads takes longer
  const IrregularRows& rows = stencil.irregular;
#pragma omp parallel for schedule(dynamic, 64) if (rows.count() > kRowsAlone)
  for (int32_t i = 0; i < rows.count(); ++i) {
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
}

}  // namespace burnish::cpu
