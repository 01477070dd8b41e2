#pragma once

#include "server/solver/cuda/device/views.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cuda {

/// Writes one axis of a cell's gradients. They must add up to zero, because Σ_a ∇B_a = 0: with a
/// rounded sum the whole surface would drift. So the rest of the last one's float is kept too.
/// `share_of(a)`: the gradient at corner a along the axis.
template <int kAxis, bool kRests, typename ShareOf>
__device__ void write_axis(ShareOf&& share_of, int64_t cell, const CellGradients& to) {
  double last = 0;
#pragma unroll
  for (int a = 0; a < 7; ++a) {
    const int64_t at = (3 * a + kAxis) * to.cells + cell;
    const double share = share_of(a);
    const auto number = static_cast<float>(share);
    to.numbers[at] = number;
    last -= number;
    if (!kRests) continue;
    const auto rest = static_cast<float>(share - number);
    to.rests[at] = rest;
    last -= rest;
  }
  const auto number = static_cast<float>(last);
  to.numbers[(21 + kAxis) * to.cells + cell] = number;
  to.numbers[(24 + kAxis) * to.cells + cell] = static_cast<float>(last - number);
}

/// `stiffness_of_pair(p)`: the combined stiffness of the cell's pairs.
template <bool kRests, typename Pair>
__device__ void write_gradients(Pair&& stiffness_of_pair, int64_t cell, const CellGradients& to) {
  const auto gradient = [&](int a, int axis) { return gradient_of(stiffness_of_pair, a, axis); };
  write_axis<0, kRests>([&](int a) { return gradient(a, 0); }, cell, to);
  write_axis<1, kRests>([&](int a) { return gradient(a, 1); }, cell, to);
  write_axis<2, kRests>([&](int a) { return gradient(a, 2); }, cell, to);
}

}  // namespace burnish::cuda
