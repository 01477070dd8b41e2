#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"
#include "server/solver/cuda/smoothers/spectrum.h"

namespace burnish::cuda {

/// (B_c + reg)⁻¹ of every cell, B_c the 8×8 block of the diagonally scaled S at its corners; of S's
/// entries with their rests, or of the packed ones alone.
void invert_cells(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                  bool with_rests);

/// The rows of M⁻¹ = D^-½ Σ_c R_cᵀ inverse_c R_c D^-½, and with them an iteration for λmax of M⁻¹S.
/// `room`: one for each corner, of working memory.
void assemble_inverse(Stream& stream, const Depth& depth, const CellSquares<float>& inverses,
                      const Matrix& inverse, const PowerStep& power, float4* room);

}  // namespace burnish::cuda
