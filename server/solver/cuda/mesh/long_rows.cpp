#include "server/solver/cuda/mesh/long_rows.h"

namespace burnish::cuda {

LongRowTails long_row_tails(const Stencil& stencil) {
  LongRowTails tails;
  tails.start = {0};
  for (int32_t i = 0; i < static_cast<int32_t>(stencil.mask.size()); ++i) {
    const int64_t end = stencil.row(i).end;
    for (int64_t k = packed_part(stencil, i).end; k < end; ++k)
      tails.column.push_back(stencil.column[k]);
    tails.start.push_back(static_cast<int32_t>(tails.column.size()));
  }
  if (tails.column.empty()) tails.start.clear();
  return tails;
}

}  // namespace burnish::cuda
