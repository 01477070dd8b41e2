#include "server/solver/cpu/cell_inverse.h"

#include <algorithm>
#include <cmath>

#include "common/base/dispatch.h"

namespace burnish::cpu {

static constexpr float kRegularisation = 1e-3f;  // on the unit diagonal of the scaled blocks
static constexpr int32_t kCellsPerBlock = 1024;

namespace {

struct Source {
  const Stencil& stencil;
  const std::array<int32_t, kCornersPerCell>* cell_corners;
  const float* entry;
  const float* scale;
};

}  // namespace

[[gnu::always_inline]] static inline void read_scaled_block(const Source& source, int32_t cell,
                                                            float (&block)[8][8]) {
  const auto& corners = source.cell_corners[cell];
#pragma GCC unroll 8
  for (int a = 0; a < 8; ++a) {
    block[a][a] = 1 + kRegularisation;
#pragma GCC unroll 8
    for (int b = a + 1; b < 8; ++b) {
      const int64_t k = source.stencil.position(corners[a], slot_between(a, b));
      block[a][b] = block[b][a] =
          source.entry[k] * source.scale[corners[a]] * source.scale[corners[b]];
    }
  }
}

// −m⁻¹ of two blocks by sweeping each pivot in turn, which keeps a block symmetric, so that a
// column is read from its row. No pivoting: a block is positive definite with a condition number of
// at most 8 / reg. Two at a time, because a pivot waits for the one before.
[[gnu::always_inline]] static inline void sweep(Float8 (&blocks)[2][8]) {
#pragma GCC unroll 8
  for (int p = 0; p < 8; ++p)
#pragma GCC unroll 2
    for (auto& m : blocks) {
      const Float8 column = m[p];
      const float inverse_pivot = 1 / column[p];
      Float8 row = column * inverse_pivot;
      m[p] = row;
      m[p][p] = -inverse_pivot;
      row[p] = 1 - inverse_pivot;  // column[a] (1 − row[p]) is what stays of column p
#pragma GCC unroll 8
      for (int a = 0; a < 8; ++a)
        if (a != p) m[a] -= column[a] * row;
    }
}

[[gnu::always_inline]] static inline void store(const Float8 (&m)[8], CellInverse& out) {
  for (int a = 0, p = 0; a < 8; ++a) {
    out.diagonal[a] = -m[a][a];
    for (int b = a + 1; b < 8; ++b, ++p) out.pair[p] = -m[a][b];
  }
}

BURNISH_DISPATCH static void invert_range(const Source& source, int32_t begin, int32_t end,
                                          CellInverse* out) {
  for (int32_t cell = begin; cell < end; cell += 2, out += 2) {
    const bool has_second = cell + 1 < end;
    alignas(Float8) float blocks[2][8][8];
    read_scaled_block(source, cell, blocks[0]);
    read_scaled_block(source, has_second ? cell + 1 : cell, blocks[1]);
    Float8 m[2][8];
    __builtin_memcpy(m, blocks, sizeof m);
    sweep(m);
    store(m[0], out[0]);
    if (has_second) store(m[1], out[1]);
  }
}

std::vector<float> diagonal_scale(const CpuDepth& depth) {
  std::vector<float> scale(depth.inverse_diagonal.size());
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < scale.size(); ++i) scale[i] = std::sqrt(depth.inverse_diagonal[i]);
  return scale;
}

Scratch<CellInverse> invert_cells(const CpuDepth& depth, const std::vector<float>& scale) {
  const int32_t cells = depth.topology.grid.cell_count();
  Scratch<CellInverse> inverses(cells);
  const Source source = {depth.topology.stencil, depth.topology.grid.cell_corners.data(),
                         depth.system.entry.data(), scale.data()};
#pragma omp parallel for schedule(static)
  for (int32_t begin = 0; begin < cells; begin += kCellsPerBlock)
    invert_range(source, begin, std::min(cells, begin + kCellsPerBlock), &inverses[begin]);
  return inverses;
}

}  // namespace burnish::cpu
