#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "server/solver/cpu/cpu_depth.h"
#include "server/solver/cpu/scratch.h"

namespace burnish::cpu {

/// D^-½ (B_c + reg)⁻¹ D^-½ of one cell, zero at pinned corners. B_c is the 8×8 block of the
/// diagonally scaled S at the cell's corners, D the diagonal of S. pair_index() gives the order of
/// the pairs.
struct CellInverse {
  std::array<float, kPairsPerCell> pair;
  std::array<float, 8> diagonal;
};

/// Returns the inverse blocks of all cells. `careful`: reg is as large as a block's diagonal.
Scratch<CellInverse> invert_cells(const CpuDepth& depth, bool careful = false);
/// Returns those of some cells, the others uninitialised. Shapes: `cells` rises.
Scratch<CellInverse> invert_cells(const CpuDepth& depth, bool careful,
                                  std::span<const int32_t> cells);

}  // namespace burnish::cpu
