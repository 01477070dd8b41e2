#pragma once

#include <array>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cpu/scratch.h"

namespace burnish::cpu {

/// (B_c + reg)⁻¹ of one cell, B_c the 8×8 block of the diagonally scaled S at the cell's corners:
/// the pairs, packed as pair_index() says, and the diagonal.
struct CellInverse {
  std::array<float, 28> pair;
  std::array<float, 8> diagonal;
};

/// D^-½ of the depth's S, 0 where pinned.
std::vector<float> diagonal_scale(const CpuDepth& depth);

/// The inverse blocks of all cells. Shapes: `scale` per corner.
Scratch<CellInverse> invert_cells(const CpuDepth& depth, const std::vector<float>& scale);

}  // namespace burnish::cpu
