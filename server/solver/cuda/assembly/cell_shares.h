#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Adds a coarse depth's shares (cell_shares.h) to the numbers of its cells. Sets the numbers of
/// its ties, which stand after the cells' on both depths. Call after the children's sums.
void add_shares(Stream& stream, const Shares& shares, const CellSquares<double>& fine,
                const CellSquares<double>& coarse);

}  // namespace burnish::cuda
