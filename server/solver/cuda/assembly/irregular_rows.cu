#include "server/solver/cuda/assembly/gather_rows.h"
#include "server/solver/cuda/assembly/irregular_rows.h"
#include "server/solver/cuda/products/block_inverse.h"
#include "server/solver/cuda/products/products.h"
#include "server/solver/hierarchy/block_sizes.h"

namespace burnish::cuda {

namespace {

// An irregular row; a warp does it.
struct Row {
  int32_t corner;
  int64_t first_sum;
  int count;  // entries, each a sum; the row's own sum comes after them
};

// Entry p of a row. Long rows have their last entries elsewhere.
struct Place {
  bool is_packed;
  int64_t at;
  uint32_t local;
  int32_t column;
};

__device__ Row row_of_warp(const Irregular& irregular, int64_t number) {
  const int64_t first = irregular.sum_start[number];
  return {irregular.corner[number], first,
          static_cast<int>(irregular.sum_start[number + 1] - first) - 1};
}

__device__ int64_t place_in_tail(const LongRows& rows, int32_t corner, int p) {
  return rows.start[corner] + p - kEntriesMax;
}

__device__ Place place_of(const Rows& rows, int32_t corner, int p) {
  if (p >= kEntriesMax) {
    const int64_t at = place_in_tail(rows.long_rows, corner, p);
    return {false, at, 0, rows.long_rows.column[at]};
  }
  const int64_t at = row_begin(rows, corner) + kSliceRows * p;
  const uint32_t local = rows.local[at];
  return {true, at, local, column_of(group_of(rows, corner / rows.group_rows), local)};
}

// Returns the value as products will read it.
__device__ float store(const Matrix& matrix, const Place& place, float value) {
  if (!place.is_packed) return matrix.long_entries[place.at] = value;
  return value_of(matrix.packed[place.at] = pack(value, place.local));
}

__device__ float entry_at(const Depth& depth, int32_t corner, int p) {
  if (p >= kEntriesMax)
    return depth.system.long_entries[place_in_tail(depth.topology.rows.long_rows, corner, p)];
  return value_of(depth.system.packed[row_begin(depth.topology.rows, corner) + kSliceRows * p]);
}

// A sum of listed numbers, of every `step` th. Finds the places of the first few at once, which may
// come before await_previous().
class ListedSum {
 public:
  __device__ ListedSum(const Irregular& irregular, int64_t sum, int first, int step)
      : source_(irregular.source),
        next_(irregular.source_start[sum] + first),
        end_(irregular.source_start[sum + 1]),
        step_(step) {
    fetch();
  }

  /// Sums only the numbers before `number_count`. In double: diagonals need it (gather_rows.h).
  template <typename Real>
  __device__ double of(const Real* numbers, int32_t number_count) {
    double total = sum_of_fetched(numbers, number_count);
    while (next_ < end_) {
      fetch();
      total += sum_of_fetched(numbers, number_count);
    }
    return total;
  }

 private:
  static constexpr int kAhead = 4;

  __device__ void fetch() {
#pragma unroll
    for (int j = 0; j < kAhead; ++j, next_ += step_) place_[j] = next_ < end_ ? source_[next_] : -1;
  }

  template <typename Real>
  __device__ double sum_of_fetched(const Real* numbers, int32_t number_count) const {
    double total = 0;
#pragma unroll
    for (int j = 0; j < kAhead; ++j)
      total += place_[j] >= 0 && place_[j] < number_count ? numbers[place_[j]] : 0;
    return total;
  }

  const int32_t* source_;
  int64_t next_, end_;
  int step_;
  int32_t place_[kAhead];
};

// Returns whether to pass over a block that is not listed. Such a thread has waited, because the
// next kernel relies on it.
__device__ bool passes_over(const BlockList& listed, int32_t block) {
  if (listed.lists == nullptr || is_listed(listed, block)) return false;
  await_previous();
  return true;
}

template <typename Real>
__device__ Real sum_of_warp(Real number) {
  for (int offset = 16; offset > 0; offset /= 2)
    number += __shfl_xor_sync(0xffffffffu, number, offset);
  return number;
}

__device__ float4 sum_of_warp(float4 vector) {
  return {sum_of_warp(vector.x), sum_of_warp(vector.y), sum_of_warp(vector.z), 0};
}

__global__ void assemble_rows_kernel(Depth depth, const double* numbers, const float4* probe,
                                     const float* pinned_below, BlockList listed) {
  let_next_start();
  const Topology& topology = depth.topology;
  const int64_t number = thread_index() / 32;
  if (number >= topology.irregular.row_count) return;
  const Row row = row_of_warp(topology.irregular, number);
  if (passes_over(listed, row.corner / topology.rows.group_rows)) return;
  const auto lane = static_cast<int>(threadIdx.x % 32);
  const auto all = static_cast<int32_t>(topology.number_count);
  ListedSum own(topology.irregular, row.first_sum + row.count, lane, 32);
  double sum = 0;
  float4 product = zero4();
  for (int p = lane; p < row.count; p += 32) {
    ListedSum listed(topology.irregular, row.first_sum + p, 0, 1);
    const Place place = place_of(topology.rows, row.corner, p);
    if (p == lane) await_previous();
    const double entry = listed.of(numbers, all);
    const float stored = store(depth.system, place, static_cast<float>(entry));
    if (depth.system.rest != nullptr && place.is_packed)
      depth.system.rest[place.at] = static_cast<float>(entry - stored);
    if (probe != nullptr) product = product + stored * probe[place.column];
    sum -= entry;
  }
  await_previous();
  const auto diagonal = static_cast<float>(sum_of_warp(sum + own.of(numbers, all)));
  product = sum_of_warp(product);
  if (lane != 0) return;
  depth.system.diagonal[row.corner] = diagonal;
  const bool is_free = diagonal > *pinned_below && row.corner < topology.known_count;
  depth.inverse_diagonal[row.corner] = is_free ? 1 / diagonal : 0;
  if (probe != nullptr) depth.r[row.corner] = product + diagonal * probe[row.corner];
}

__global__ void invert_irregular_kernel(Depth depth, CellSquares<float> inverses,
                                        float regularisation, BlockList listed) {
  let_next_start();
  const Irregular& irregular = depth.topology.irregular;
  const int64_t number = thread_index();
  if (number >= irregular.cell_count) return;
  const int32_t cell = irregular.cell[number];
  if (passes_over(listed, cell / kCellsOfBlock)) return;
  const PairEntries entries = irregular.entry[number];
  const Eight corners = depth.topology.cell_corners[cell];
  await_previous();
  float block[8][8];
  const auto entry_of = [&](int a, int b) {
    return entry_at(depth, corners.at[a], entries.at[pair_index(a, b)]);
  };
  read_scaled_block(depth, corners, regularisation, entry_of, block);
  invert(regularisation, block);
  store_block(block, cell, inverses);
}

// Uses the numbers of cells only: ties have no part in M⁻¹.
__global__ void inverse_rows_kernel(Depth depth, CellSquares<float> inverses, Matrix inverse,
                                    const float4* vector, float4* next, BlockList listed) {
  let_next_start();
  const Topology& topology = depth.topology;
  const int64_t number = thread_index() / 32;
  if (number >= topology.irregular.row_count) return;
  const Row row = row_of_warp(topology.irregular, number);
  if (passes_over(listed, row.corner / topology.rows.group_rows)) return;
  const auto lane = static_cast<int>(threadIdx.x % 32);
  const auto of_cells = static_cast<int32_t>(inverses.kNumbers * inverses.cells);
  ListedSum own(topology.irregular, row.first_sum + row.count, lane, 32);
  float4 product = zero4();
  for (int p = lane; p < row.count; p += 32) {
    ListedSum listed(topology.irregular, row.first_sum + p, 0, 1);
    const Place place = place_of(topology.rows, row.corner, p);
    if (p == lane) await_previous();
    const float scale =
        sqrtf(depth.inverse_diagonal[row.corner]) * sqrtf(depth.inverse_diagonal[place.column]);
    const auto sum = static_cast<float>(listed.of(inverses.numbers, of_cells));
    const float stored = store(inverse, place, sum * scale);
    product = product + stored * vector[place.column];
  }
  await_previous();
  const auto own_sum = static_cast<float>(sum_of_warp(own.of(inverses.numbers, of_cells)));
  const float diagonal = own_sum * depth.inverse_diagonal[row.corner];
  product = sum_of_warp(product);
  if (lane != 0) return;
  inverse.diagonal[row.corner] = diagonal;
  next[row.corner] = product + diagonal * vector[row.corner];
}

}  // namespace

void assemble_irregular_rows(Stream& stream, const CellSquares<double>& cells, const Depth& depth,
                             const float4* probe, const float* pinned_below,
                             const BlockList& listed) {
  launch(stream, assemble_rows_kernel, int64_t{32} * depth.topology.irregular.row_count, depth,
         cells.numbers, probe, pinned_below, listed);
}

void invert_irregular_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                            float regularisation, const BlockList& listed) {
  launch(stream, invert_irregular_kernel, depth.topology.irregular.cell_count, depth, inverses,
         regularisation, listed);
}

void assemble_irregular_inverse(Stream& stream, const Depth& depth,
                                const CellSquares<float>& inverses, const Matrix& inverse,
                                const PowerStep& power, float4* next, const BlockList& listed) {
  launch(stream, inverse_rows_kernel, int64_t{32} * depth.topology.irregular.row_count, depth,
         inverses, inverse, power.product, next, listed);
}

}  // namespace burnish::cuda
