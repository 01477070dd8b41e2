#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/smoothers/spectrum.h"

namespace burnish::cuda {

/// Makes (B_c + reg)⁻¹ of every cell; B_c is the 8×8 block of the diagonally scaled S at its
/// corners. Uses S's entries with their rests, or the packed ones alone. `careful`: reg is as large
/// as a block's diagonal. `listed`: the blocks of cells to do, or all.
void invert_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                  bool with_rests, bool careful, const BlockList& listed);

/// Makes the rows of M⁻¹ = D^-½ Σ_c R_cᵀ inverse_c R_c D^-½, and an iteration for λmax of M⁻¹S. For
/// listed blocks of rows alone it makes no iteration. `room`: working memory, one per corner.
void assemble_inverse(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                      const Matrix& inverse, const PowerStep& power, float4* room,
                      const BlockList& listed);

}  // namespace burnish::cuda
