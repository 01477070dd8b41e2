#include "server/solver/cpu/smoothers/cell_inverse.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "common/base/dispatch.h"
#include "common/grid/stencil_slots.h"
#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cpu {

// Added to the unit diagonal of the scaled blocks. At the finest depth it is as small as float32
// allows, whose rounding is a tenth of it. The block of a thin small component that hangs by two
// corners has its least eigenvalue far below, so the addition hides the small component from the
// smoother. At coarser depths less than 1e-3 would show the cycle more such functions than it can
// resolve: skins would converge more slowly.
static constexpr float kFinestRegularisation = 1e-5f;
static constexpr float kCoarseRegularisation = 1e-3f;
static constexpr float kCarefulRegularisation = 1;
static constexpr int32_t kCellsPerBlock = 1024;
static constexpr int32_t kCellsAhead = 32;
static constexpr int kLanes = 16;  // cells that are inverted together

namespace {

struct Source {
  const Stencil& stencil;
  const std::array<int32_t, kCornersPerCell>* cell_corners;
  const float* entry;
  const float* inverse_diagonal;
  float regularisation;
  const int32_t* only = nullptr;  // cells to invert; null: all

  int32_t cell(int32_t i) const { return only == nullptr ? i : only[i]; }
};

using Lanes = float __attribute__((vector_size(4 * kLanes)));

/// The blocks of several cells, a cell in each lane.
struct Blocks {
  Lanes pair[kPairsPerCell];
  Lanes diagonal[8];
  Lanes scale[8];  // D^-½
};

}  // namespace

[[gnu::always_inline]] static inline void read_cell(const Source& source, int32_t cell, int lane,
                                                    Blocks& blocks) {
  const auto& corners = source.cell_corners[cell];
#pragma GCC unroll 8
  for (int a = 0; a < kCornersPerCell; ++a) {
    blocks.scale[a][lane] = source.inverse_diagonal[corners[a]];
#pragma GCC unroll 8
    for (int b = a + 1; b < kCornersPerCell; ++b)
      blocks.pair[pair_index(a, b)][lane] =
          source.entry[source.stencil.position(corners[a], slot_between(a, b))];
  }
}

// Prefetches the rows of corners that no earlier cell has.
[[gnu::always_inline]] static inline void prefetch_cell(const Source& source, int32_t cell) {
  const auto& corners = source.cell_corners[cell];
#pragma GCC unroll 8
  for (int a = 1; a < kCornersPerCell; ++a)
    __builtin_prefetch(source.entry +
                       source.stencil.row_start[source.stencil.row_of_corner[corners[a]]]);
}

[[gnu::always_inline]] static inline void scale_pairs(Blocks& blocks) {
#pragma GCC unroll 8
  for (int a = 0; a < kCornersPerCell; ++a)
#pragma GCC unroll 8
    for (int b = a + 1; b < kCornersPerCell; ++b)
      blocks.pair[pair_index(a, b)] *= blocks.scale[a] * blocks.scale[b];
}

// Makes −m⁻¹ by sweeping each pivot in turn. This keeps a block symmetric, so half of it is enough.
// No pivoting: a block is positive definite with a condition number of at most 8 / reg. Its pivots
// are at least reg, and rounding must not bring one below.
[[gnu::always_inline]] static inline void sweep(Blocks& blocks, float regularisation) {
#pragma GCC unroll 8
  for (int p = 0; p < kCornersPerCell; ++p) {
    const Lanes least = Lanes{} + regularisation;
    const Lanes pivot = blocks.diagonal[p] > least ? blocks.diagonal[p] : least;
    const Lanes inverse_pivot = 1 / pivot;
    Lanes column[8], row[8];
#pragma GCC unroll 8
    for (int a = 0; a < kCornersPerCell; ++a) {
      if (a == p) continue;
      column[a] = blocks.pair[pair_index(a, p)];
      row[a] = column[a] * inverse_pivot;
      blocks.pair[pair_index(a, p)] = row[a];
    }
    blocks.diagonal[p] = -inverse_pivot;
#pragma GCC unroll 8
    for (int a = 0; a < kCornersPerCell; ++a) {
      if (a == p) continue;
      blocks.diagonal[a] -= column[a] * row[a];
#pragma GCC unroll 8
      for (int b = a + 1; b < kCornersPerCell; ++b)
        if (b != p) blocks.pair[pair_index(a, b)] -= column[a] * row[b];
    }
  }
}

[[gnu::always_inline]] static inline void write_cell(const Blocks& blocks, int lane,
                                                     CellInverse& out) {
  for (int p = 0; p < kPairsPerCell; ++p) out.pair[p] = -blocks.pair[p][lane];
  for (int a = 0; a < 8; ++a) out.diagonal[a] = -blocks.diagonal[a][lane];
}

[[gnu::always_inline]] static inline void invert(Blocks& blocks, float regularisation) {
  for (int a = 0; a < kCornersPerCell; ++a) {
    for (int lane = 0; lane < kLanes; ++lane)
      blocks.scale[a][lane] = std::sqrt(blocks.scale[a][lane]);
    blocks.diagonal[a] = Lanes{} + (1 + regularisation);
  }
  scale_pairs(blocks);
  sweep(blocks, regularisation);
  scale_pairs(blocks);
  for (int a = 0; a < kCornersPerCell; ++a) blocks.diagonal[a] *= blocks.scale[a] * blocks.scale[a];
}

BURNISH_DISPATCH static void invert_range(const Source& source, int32_t begin, int32_t end,
                                          CellInverse* out) {
  for (int32_t first = begin; first < end; first += kLanes) {
    Blocks blocks;
    for (int lane = 0; lane < kLanes; ++lane) {
      prefetch_cell(source, source.cell(std::min(first + lane + kCellsAhead, end - 1)));
      read_cell(source, source.cell(std::min(first + lane, end - 1)), lane, blocks);
    }
    invert(blocks, source.regularisation);
    for (int lane = 0; lane < std::min(kLanes, end - first); ++lane)
      write_cell(blocks, lane, out[source.cell(first + lane)]);
  }
}

// Reads cells with an irregular corner: slots do not find their entries.
static void read_irregular_cell(const Source& source, int32_t i, int lane, Blocks& blocks) {
  const IrregularCells& cells = source.stencil.irregular_cells;
  const auto& corners = source.cell_corners[cells.cell[i]];
  for (int a = 0; a < kCornersPerCell; ++a) {
    blocks.scale[a][lane] = source.inverse_diagonal[corners[a]];
    const float* row = source.entry + source.stencil.row(corners[a]).begin;
    for (int b = a + 1; b < kCornersPerCell; ++b)
      blocks.pair[pair_index(a, b)][lane] = row[cells.entry[i][pair_index(a, b)]];
  }
}

// Shapes: `which` are indices of irregular cells.
static void invert_irregular_cells(const Source& source, std::span<const int32_t> which,
                                   Scratch<CellInverse>& inverses) {
  const auto count = static_cast<int32_t>(which.size());
#pragma omp parallel for schedule(static) if (count > kCellsPerBlock)
  for (int32_t first = 0; first < count; first += kLanes) {
    Blocks blocks;
    for (int lane = 0; lane < kLanes; ++lane)
      read_irregular_cell(source, which[std::min(first + lane, count - 1)], lane, blocks);
    invert(blocks, source.regularisation);
    for (int lane = 0; lane < std::min(kLanes, count - first); ++lane)
      write_cell(blocks, lane, inverses[source.stencil.irregular_cells.cell[which[first + lane]]]);
  }
}

static Source source_of(const CpuDepth& depth, bool careful) {
  const float usual = depth.topology.is_finest() ? kFinestRegularisation : kCoarseRegularisation;
  return {depth.topology.stencil, depth.topology.grid.cell_corners.data(),
          depth.system.entry.data(), depth.inverse_diagonal.data(),
          careful ? kCarefulRegularisation : usual};
}

static void invert_listed(const Source& source, int32_t cells, Scratch<CellInverse>& inverses) {
#pragma omp parallel for schedule(dynamic) if (cells > kCellsPerBlock)
  for (int32_t begin = 0; begin < cells; begin += kCellsPerBlock)
    invert_range(source, begin, std::min(cells, begin + kCellsPerBlock), &inverses[0]);
}

Scratch<CellInverse> invert_cells(const CpuDepth& depth, bool careful) {
  const int32_t cells = depth.topology.grid.cell_count();
  Scratch<CellInverse> inverses(cells);
  const Source source = source_of(depth, careful);
  invert_listed(source, cells, inverses);
  std::vector<int32_t> irregular(depth.topology.stencil.irregular_cells.cell.size());
  std::iota(irregular.begin(), irregular.end(), 0);
  invert_irregular_cells(source, irregular, inverses);
  return inverses;
}

Scratch<CellInverse> invert_cells(const CpuDepth& depth, bool careful,
                                  std::span<const int32_t> cells) {
  Scratch<CellInverse> inverses(depth.topology.grid.cells.size());
  Source source = source_of(depth, careful);
  source.only = cells.data();
  invert_listed(source, static_cast<int32_t>(cells.size()), inverses);
  const std::vector<int32_t>& irregular = depth.topology.stencil.irregular_cells.cell;
  std::vector<int32_t> which;
  for (const int32_t cell : cells) {
    const auto there = std::ranges::lower_bound(irregular, cell);
    if (there != irregular.end() && *there == cell)
      which.push_back(static_cast<int32_t>(there - irregular.begin()));
  }
  invert_irregular_cells(source, which, inverses);
  return inverses;
}

}  // namespace burnish::cpu
