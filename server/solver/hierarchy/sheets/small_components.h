#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/solver/hierarchy/sheets/sheet_corners.h"

namespace burnish {

/// A small piece of surface at the finest depth.
struct SmallComponent {
  std::vector<int32_t> copies;   ///< of corners: the piece hangs together by them
  std::vector<int32_t> corners;  ///< one per copy
  std::vector<int32_t> patch;    ///< corners to solve as a whole; rising
  /// It hangs on another small component and no patch has room for both, or there is no large
  /// piece.
  bool needs_coarse_cells = false;
};

/// Finds the pieces with at most kPatchCornersMax copies of corners. A small component that hangs
/// on another sheet by a corner moves with almost no energy as long as that sheet gives way. No
/// coarse function moves the small component and bends the sheet in just that way. So its patch
/// also has the corners of all cells around the corners that it shares, unless these are too many.
///
/// Small components that hang on each other are one if a patch has room for both.
///
/// Returns nothing if no piece shares a corner.
std::vector<SmallComponent> find_small_components(const SparseGrid& finest,
                                                  const SheetCorners& sheets);

/// Finds what each small component follows on coarse depths: a copy of the surface that it hangs
/// on, directly or by other small components. kNone: it floats. Shapes: one per small component.
std::vector<int32_t> find_anchors(std::span<const SmallComponent> components,
                                  const SheetCorners& sheets);

}  // namespace burnish
