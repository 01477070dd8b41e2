#pragma once

#include <cstdint>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/sheet_corners.h"

namespace burnish {

/// The corners that a patch has at most: room for its factor in a CUDA block's shared memory.
inline constexpr int kPatchCornersMax = 120;

/// Small pieces of the finest depth, each with what it hangs on: relaxed as a whole, because such a
/// piece moves with next to no energy as long as the sheet that holds it gives way, and a coarse
/// function that moves the one and bends the other just so there is none.
///
/// A piece is what hangs together by copies of corners; a patch has a piece's corners and those of
/// all cells around the corners that it shares with others, or without these where they are too
/// many. Patches of a colour have no cell in common: none reads what another writes.
struct Patches {
  std::vector<int32_t> start = {0};         ///< patches + 1, into `corner`
  std::vector<int32_t> corner;              ///< rising within a patch
  std::vector<int32_t> colour_start = {0};  ///< colours + 1, into the patches
  std::vector<int64_t> entry_start = {0};   ///< patches + 1: of their lower triangles, by rows

  int32_t count() const { return static_cast<int32_t>(start.size() - 1); }
  int32_t colour_count() const { return static_cast<int32_t>(colour_start.size() - 1); }
  int64_t entry_count() const { return entry_start.back(); }
};

/// No patch for a piece of more corners than a patch may have, nor for what comes after the limits
/// on all patches' entries (16 a corner of the depth) and on colours (64) are reached.
Patches find_patches(const SparseGrid& finest, const SheetCorners& sheets);

}  // namespace burnish
