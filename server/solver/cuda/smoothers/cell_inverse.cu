#include "server/solver/cuda/assembly/gather_rows.h"
#include "server/solver/cuda/assembly/irregular_rows.h"
#include "server/solver/cuda/products/block_inverse.h"
#include "server/solver/cuda/products/products.h"
#include "server/solver/cuda/smoothers/cell_inverse.h"
#include "server/solver/cuda/smoothers/power_step.h"
#include "server/solver/hierarchy/block_sizes.h"

namespace burnish::cuda {

namespace {

static_assert(kCellsOfBlock == kThreads);

// It reads some wrong entries for irregular cells: their inverses are made later.
template <bool kRests>
__device__ __forceinline__ void invert_cell(const Depth& depth, const CellSquares<float>& inverses,
                                            float regularisation, int64_t cell) {
  if (cell >= depth.topology.cell_count) return;
  const Eight corners = depth.topology.cell_corners[cell];
  float block[8][8];
  const auto entry_of = [&](int a, int b) {
    const int64_t k = entry_position(depth.topology.rows, corners.at[a], slot_between(a, b));
    return value_of(depth.system.packed[k]) + (kRests ? depth.system.rest[k] : 0);
  };
  read_scaled_block(depth, corners, regularisation, entry_of, block);
  invert(regularisation, block);
  store_block(block, cell, inverses);
}

template <bool kRests, bool kListed>
__global__ void invert_cells_kernel(Depth depth, CellSquares<float> inverses, float regularisation,
                                    BlockList listed) {
  await_previous();
  for_own_blocks<kListed>(listed, [&](int32_t block) {
    invert_cell<kRests>(depth, inverses, regularisation,
                        int64_t{block} * kThreads + static_cast<int>(threadIdx.x));
  });
}

// The tile has the power iteration's S x, and in w the square root of the inverse diagonal.
// Irregular rows are done already; `irregular_next` holds their values. Returns the thread's sums.
template <bool kIrregular, bool kIterates>
__device__ __forceinline__ Sums<2> assemble_inverse_of_group(
    const Depth& depth, const CellSquares<float>& inverses, const Matrix& inverse,
    const PowerStep& power, const float4* irregular_next, int32_t block) {
  __shared__ RowRoom room;
  float4* tile = tile_of_block<float4>();
  const Rows& rows = depth.topology.rows;
  const TilePart part = fetch_part(rows, block);
  const int32_t corner = part.corner;
  const Eight cells_here = cells_around(depth.topology, corner);
  await_previous();
  const GatheredRow<float> row = gather_row(inverses, cells_here);
  const auto scaled_product = [&](int32_t i) {
    float4 number = kIterates ? power.product[i] : zero4();
    number.w = sqrtf(depth.inverse_diagonal[i]);
    return number;
  };
  fill_tile_with(part, scaled_product, tile);
  Sums<2> sums = {};
  if (corner >= 0) {
    const float4 here = tile[threadIdx.x];
    float4 next;
    if (kIrregular && !is_regular(cells_here)) {
      next = kIterates ? irregular_next[corner] : zero4();
    } else {
      const float diagonal = row.own * here.w * here.w;
      inverse.diagonal[corner] = diagonal;
      next = diagonal * here;
      const auto itself = [](float value) { return value; };
      store_row(rows, corner, row, room, itself, [&](int64_t k, float value, uint32_t local) {
        const float4 there = tile[local];
        float entry = value * here.w * there.w;
        const uint32_t packed = pack(entry, local);
        inverse.packed[k] = packed;
        if (inverse.rest != nullptr)
          inverse.rest[k] = entry - value_of(packed);
        else
          entry = value_of(packed);
        next = next + entry * there;
      });
    }
    if (kIterates)
      replace(power, corner, next, here.w != 0 ? here : zero4(), power.spectrum->normalise, sums);
  }
  return sums;
}

template <bool kIrregular>
__global__ void assemble_inverse_kernel(Depth depth, CellSquares<float> inverses, Matrix inverse,
                                        PowerStep power, const float4* irregular_next) {
  let_next_start();
  update_spectrum(power, assemble_inverse_of_group<kIrregular, true>(
                             depth, inverses, inverse, power, irregular_next,
                             static_cast<int32_t>(blockIdx.x)));
}

template <bool kIrregular>
__global__ void assemble_listed_inverse_kernel(Depth depth, CellSquares<float> inverses,
                                               Matrix inverse, PowerStep power, BlockList listed) {
  let_next_start();
  for_own_blocks<true>(listed, [&](int32_t block) {
    assemble_inverse_of_group<kIrregular, false>(depth, inverses, inverse, power, nullptr, block);
  });
}

auto choose_inversion(bool with_rests, bool is_listed) {
  if (is_listed)
    return with_rests ? invert_cells_kernel<true, true> : invert_cells_kernel<false, true>;
  return with_rests ? invert_cells_kernel<true, false> : invert_cells_kernel<false, false>;
}

}  // namespace

void invert_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                  bool with_rests, bool careful, const BlockList& listed) {
  const auto regularisation = [=](float usual) { return careful ? kCarefulRegularisation : usual; };
  launch_blocks(stream, choose_inversion(with_rests, listed.lists != nullptr),
                blocks_for(block_count(depth.topology.cell_count), listed), dim3(kThreads), 0,
                depth, inverses,
                regularisation(with_rests ? kRegularisationWithRests : kRegularisation), listed);
  invert_irregular_cells(stream, depth, inverses, regularisation(kRegularisation), listed);
}

void assemble_inverse(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                      const Matrix& inverse, const PowerStep& power, float4* room,
                      const BlockList& listed) {
  const Rows& rows = depth.topology.rows;
  const bool is_irregular = depth.topology.irregular.row_count > 0;
  assemble_irregular_inverse(stream, depth, inverses, inverse, power, room, listed);
  if (listed.lists != nullptr)
    return launch_products<float4>(
        stream,
        is_irregular ? assemble_listed_inverse_kernel<true> : assemble_listed_inverse_kernel<false>,
        rows, static_cast<int32_t>(blocks_for(rows.group_count, listed).x), depth, inverses,
        inverse, power, listed);
  launch_products<float4>(
      stream, is_irregular ? assemble_inverse_kernel<true> : assemble_inverse_kernel<false>, rows,
      rows.group_count, depth, inverses, inverse, power, room);
}

}  // namespace burnish::cuda
