#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Adds a coarse depth's shares (cell_shares.h) to the numbers of its cells, and sets those of its
/// ties, which stand behind the cells' on both depths. After what children give.
template <typename Real>
void add_shares(Stream& stream, const Shares& shares, const CellSquares<Real>& fine,
                const CellSquares<float>& coarse);

}  // namespace burnish::cuda
