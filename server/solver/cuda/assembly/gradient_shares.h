#pragma once

#include <type_traits>

#include "server/solver/cuda/device/kernel.h"

namespace burnish::cuda {

/// A cell's share of b for one axis: a double with rests, else a float.
template <bool kRests>
using Share = std::conditional_t<kRests, double, float>;

/// One axis of the shares of a corner's cells, and the rest of the last float. A missing cell
/// counts as the first one, times zero, so its loads need not wait for a branch.
template <bool kRests>
struct AxisShares {
  Share<kRests> at[8];
  float rest;
};

template <bool kRests>
__device__ AxisShares<kRests> shares_of(const CellGradients& combined, const Eight& cells,
                                        int axis) {
  const auto place = [&](int n, int a) {
    return (n + axis) * combined.cells + max(cells.at[a], 0);
  };
  AxisShares<kRests> shares;
#pragma unroll
  for (int a = 0; a < 8; ++a) shares.at[a] = combined.numbers[place(3 * a, a)];
  if constexpr (kRests)
#pragma unroll
    for (int a = 0; a < 7; ++a) shares.at[a] += combined.rests[place(3 * a, a)];
  shares.rest = combined.numbers[place(24, 7)];
  return shares;
}

template <bool kRests>
__device__ double weighed(const AxisShares<kRests>& shares, const float (&weight)[8]) {
  double sum = weight[7] * static_cast<double>(shares.rest);
#pragma unroll
  for (int a = 0; a < 8; ++a) sum += weight[a] * static_cast<double>(shares.at[a]);
  return sum;
}

/// Returns the change of b per slider step at a corner without paint: the sum over its cells.
template <bool kRests>
__device__ Double3 sum_shares(const CellGradients& combined, const Eight& cells) {
  float weight[8];  // 1, or 0 for a missing cell
#pragma unroll
  for (int a = 0; a < 8; ++a) weight[a] = static_cast<float>(min(cells.at[a], 0) + 1);
  double sum[3];
#pragma unroll
  for (int axis = 0; axis < 3; ++axis)
    sum[axis] = weighed(shares_of<kRests>(combined, cells, axis), weight);
  return {sum[0], sum[1], sum[2]};
}

}  // namespace burnish::cuda
