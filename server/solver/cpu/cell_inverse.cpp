#include "server/solver/cpu/cell_inverse.h"

#include <cmath>

namespace burnish::cpu {

static constexpr float kRegularisation = 1e-3f;  // on the unit diagonal of the scaled blocks

using Block = float[8][8];

static void read_scaled_block(const CpuDepth& depth, const std::vector<float>& scale, int32_t cell,
                              Block& block) {
  const auto& corners = depth.topology.grid.cell_corners[cell];
  for (int a = 0; a < 8; ++a) {
    block[a][a] = 1 + kRegularisation;
    for (int b = a + 1; b < 8; ++b) {
      const int64_t k = depth.topology.stencil.position(corners[a], slot_between(a, b));
      block[a][b] = block[b][a] = depth.system.entry[k] * scale[corners[a]] * scale[corners[b]];
    }
  }
}

// Gauss-Jordan without pivoting: the block is symmetric positive definite with a condition number
// of at most 8 / reg.
static void invert(Block& m) {
  for (int p = 0; p < 8; ++p) {
    const float inverse_pivot = 1 / m[p][p];
    m[p][p] = 1;
    for (int b = 0; b < 8; ++b) m[p][b] *= inverse_pivot;
    for (int a = 0; a < 8; ++a) {
      if (a == p) continue;
      const float factor = m[a][p];
      m[a][p] = 0;
      for (int b = 0; b < 8; ++b) m[a][b] -= factor * m[p][b];
    }
  }
}

static CellInverse invert_cell(const CpuDepth& depth, const std::vector<float>& scale,
                               int32_t cell) {
  Block block;
  read_scaled_block(depth, scale, cell, block);
  invert(block);
  CellInverse out;
  for (int a = 0, p = 0; a < 8; ++a) {
    out.diagonal[a] = block[a][a];
    for (int b = a + 1; b < 8; ++b, ++p) out.pair[p] = (block[a][b] + block[b][a]) / 2;
  }
  return out;
}

std::vector<float> diagonal_scale(const CpuDepth& depth) {
  std::vector<float> scale(depth.inverse_diagonal.size());
  for (size_t i = 0; i < scale.size(); ++i) scale[i] = std::sqrt(depth.inverse_diagonal[i]);
  return scale;
}

std::vector<CellInverse> invert_cells(const CpuDepth& depth, const std::vector<float>& scale) {
  const int32_t cells = depth.topology.grid.cell_count();
  std::vector<CellInverse> inverses(cells);
#pragma omp parallel for schedule(static)
  for (int32_t cell = 0; cell < cells; ++cell) inverses[cell] = invert_cell(depth, scale, cell);
  return inverses;
}

}  // namespace burnish::cpu
