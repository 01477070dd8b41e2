#pragma once

#include "server/solver/cuda/device/kernel.h"
#include "server/solver/hierarchy/cell_matrix.h"

// The 8×8 blocks of additive Schwarz: B_c + reg at the corners of a cell, and its inverse.

namespace burnish::cuda {

// Added to the unit diagonal of the scaled blocks. Packed entries change a block's norm by half of
// the first value. With their rests the CPU's small value is enough.
inline constexpr float kRegularisation = 1e-3f;
inline constexpr float kRegularisationWithRests = 1e-5f;
inline constexpr float kCarefulRegularisation = 1;  // no block fails

/// Reads the block of the diagonally scaled S; entry_of(a, b) is S's entry between corners a < b.
template <typename EntryOf>
__device__ void read_scaled_block(const Depth& depth, const Eight& corners, float regularisation,
                                  EntryOf&& entry_of, float (&block)[8][8]) {
  float scale[8];
#pragma unroll
  for (int a = 0; a < 8; ++a) scale[a] = sqrtf(depth.inverse_diagonal[corners.at[a]]);
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    block[a][a] = 1 + regularisation;
#pragma unroll
    for (int b = a + 1; b < 8; ++b)
      block[a][b] = block[b][a] = entry_of(a, b) * scale[a] * scale[b];
  }
}

/// Does Gauss-Jordan without pivoting: the block is symmetric positive definite with a condition
/// number of at most 8 / reg. Its pivots are at least reg, and rounding must not bring one below.
__device__ inline void invert(float regularisation, float (&m)[8][8]) {
#pragma unroll
  for (int p = 0; p < 8; ++p) {
    const float inverse_pivot = 1 / fmaxf(m[p][p], regularisation);
    m[p][p] = 1;
#pragma unroll
    for (int b = 0; b < 8; ++b) m[p][b] *= inverse_pivot;
#pragma unroll
    for (int a = 0; a < 8; ++a) {
      if (a == p) continue;
      const float factor = m[a][p];
      m[a][p] = 0;
#pragma unroll
      for (int b = 0; b < 8; ++b) m[a][b] -= factor * m[p][b];
    }
  }
}

__device__ inline void store_block(const float (&block)[8][8], int64_t cell,
                                   const CellSquares<float>& inverses) {
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    own_of(inverses, cell, a) = block[a][a];
#pragma unroll
    for (int b = a + 1; b < 8; ++b)
      pair_of(inverses, cell, pair_index(a, b)) = (block[a][b] + block[b][a]) / 2;
  }
}

}  // namespace burnish::cuda
