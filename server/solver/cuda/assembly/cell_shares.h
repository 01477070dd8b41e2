#pragma once

#include "server/solver/cuda/device/stream.h"
#include "server/solver/cuda/device/views.h"

namespace burnish::cuda {

/// Adds a coarse depth's shares (cell_shares.h) to the numbers of its cells. Sets the numbers of
/// its ties, which stand after the cells' on both depths. Call after the children's sums. `listed`:
/// the blocks of the depth's parts whose children have just been summed, or all.
void add_shares(Stream& stream, const Shares& shares, const CellSquares<double>& fine,
                const CellSquares<double>& coarse, const BlockList& listed);

}  // namespace burnish::cuda
