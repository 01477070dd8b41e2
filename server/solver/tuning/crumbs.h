#pragma once

#include <cstdint>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/hierarchy/sheets/sheet_corners.h"

namespace burnish {

/// Finds crumbs of the finest depth, each with the surface that it hangs on. A crumb moves with
/// almost no energy as long as the sheet that holds it gives way. No coarse function moves the
/// crumb and bends the sheet in just that way.
///
/// A piece hangs together by copies of corners. Returns a set of corners, rising, for each piece
/// that has at most kPatchCornersMax: its own corners and those of all cells around the corners
/// that it shares with others. Leaves out the latter if they are too many.
std::vector<std::vector<int32_t>> find_crumbs(const SparseGrid& finest, const SheetCorners& sheets);

}  // namespace burnish
