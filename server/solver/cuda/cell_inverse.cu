#include "server/solver/cuda/cell_inverse.h"
#include "server/solver/cuda/gather_rows.h"
#include "server/solver/cuda/power_step.h"
#include "server/solver/cuda/products.h"

namespace burnish::cuda {

namespace {

constexpr float kRegularisation = 1e-3f;  // on the unit diagonal of the scaled blocks

// Of the entries the packed part will do: it is off by 5e-4 in a block's norm at the most, half of
// the regularisation.
__device__ void read_scaled_block(const Depth& depth, const Eight& corners, float (&block)[8][8]) {
  float scale[8];
#pragma unroll
  for (int a = 0; a < 8; ++a) scale[a] = sqrtf(depth.inverse_diagonal[corners.at[a]]);
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    block[a][a] = 1 + kRegularisation;
#pragma unroll
    for (int b = a + 1; b < 8; ++b) {
      const int64_t k = entry_position(depth.topology.rows, corners.at[a], slot_between(a, b));
      block[a][b] = block[b][a] = value_of(depth.system.packed[k]) * scale[a] * scale[b];
    }
  }
}

// Gauss-Jordan without pivoting: the block is symmetric positive definite with a condition number
// of at most 8 / reg.
__device__ void invert(float (&m)[8][8]) {
#pragma unroll
  for (int p = 0; p < 8; ++p) {
    const float inverse_pivot = 1 / m[p][p];
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

__global__ void invert_cells_kernel(Depth depth, CellSquares<float> inverses) {
  await_previous();
  const int64_t cell = thread_index();
  if (cell >= depth.topology.cell_count) return;
  float block[8][8];
  read_scaled_block(depth, depth.topology.cell_corners[cell], block);
  invert(block);
#pragma unroll
  for (int a = 0; a < 8; ++a) {
    own_of(inverses, cell, a) = block[a][a];
#pragma unroll
    for (int b = a + 1; b < 8; ++b)
      pair_of(inverses, cell, pair_index(a, b)) = (block[a][b] + block[b][a]) / 2;
  }
}

// The tile has the power iteration's S x, and in w the square root of the inverse diagonal.
__global__ void assemble_inverse_kernel(Depth depth, CellSquares<float> inverses, Matrix inverse,
                                        PowerStep power) {
  __shared__ RowRoom room;
  float4* tile = tile_of_block<float4>();
  let_next_start();
  const Rows& rows = depth.topology.rows;
  const TilePart part = fetch_part(rows, blockIdx.x);
  const int32_t corner = part.corner;
  const Eight cells_here = cells_around(depth.topology, corner);
  await_previous();
  const GatheredRow<float> row = gather_row(inverses, cells_here);
  const auto scaled_product = [&](int32_t i) {
    float4 number = power.product[i];
    number.w = sqrtf(depth.inverse_diagonal[i]);
    return number;
  };
  fill_tile_with(part, scaled_product, tile);
  Sums<2> sums = {};
  if (corner >= 0) {
    const float4 here = tile[threadIdx.x];
    const float diagonal = row.own * here.w * here.w;
    inverse.diagonal[corner] = diagonal;
    float4 next = diagonal * here;
    const auto itself = [](float value) { return value; };
    store_row(rows, corner, row, room, itself, [&](int64_t k, float value, uint32_t local) {
      const float4 there = tile[local];
      const uint32_t packed = pack(value * here.w * there.w, local);
      inverse.packed[k] = packed;
      next = next + value_of(packed) * there;
    });
    replace(power, corner, next, here.w != 0 ? here : zero4(), power.spectrum->normalise, sums);
  }
  update_spectrum(power, sums);
}

}  // namespace

void invert_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses) {
  launch(stream, invert_cells_kernel, depth.topology.cell_count, depth, inverses);
}

void assemble_inverse(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                      const Matrix& inverse, const PowerStep& power) {
  const Rows& rows = depth.topology.rows;
  launch_products<float4>(stream, assemble_inverse_kernel, rows, rows.group_count, depth, inverses,
                          inverse, power);
}

}  // namespace burnish::cuda
