#pragma once

#include <cstdint>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/hierarchy/sheets/sheet_corners.h"

namespace burnish {

/// Small pieces of the finest depth that hang on others, each with what it hangs on. Such a piece
/// moves with next to no energy as long as the sheet that holds it gives way, and a coarse function
/// that moves the one and bends the other just so there is none.
///
/// A piece is what hangs together by copies of corners. Returns a set of corners, rising, for each
/// that has at most kPatchCornersMax: its own and those of all cells around the corners that it
/// shares with others, or without these where they are too many.
std::vector<std::vector<int32_t>> find_crumbs(const SparseGrid& finest, const SheetCorners& sheets);

}  // namespace burnish
