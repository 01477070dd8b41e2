#pragma once

#include <cstdint>
#include <vector>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/solver/cycle/multigrid.h"

namespace burnish {

/// Finds slow spots with a trial on the CPU, which smooths the whole surface from a cold start. A
/// slow spot still moves vertices after it should have settled: a spike that bends back within two
/// cells, a flap of two sheets in one cell, a small component that shares no corner. Like the small
/// components of small_components.h, they move with almost no energy.
///
/// Returns sets of corners, rising, the slowest spot's first. A set has the corners of the spot's
/// cell and of rings of cells around it, as many rings as fit into kPatchCornersMax. Fails:
/// cancelled.
Result<std::vector<std::vector<int32_t>>> find_slow_spots(const Multigrid& on,
                                                          const Progress& progress = {});

}  // namespace burnish
