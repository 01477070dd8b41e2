#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// The corners that a patch has at most: room for its factor in a CUDA block's shared memory.
inline constexpr int kPatchCornersMax = 120;

/// Small parts of the finest depth that are relaxed as a whole, because the smoother's cells and
/// the coarse functions between them are slow there: tuning/crumbs.h and tuning/slow_spots.h say
/// where.
///
/// Patches of a colour have no cell in common: none reads what another writes.
struct Patches {
  std::vector<int32_t> start = {0};         ///< patches + 1, into `corner`
  std::vector<int32_t> corner;              ///< rising within a patch
  std::vector<int32_t> colour_start = {0};  ///< colours + 1, into the patches
  std::vector<int64_t> entry_start = {0};   ///< patches + 1: of their lower triangles, by rows

  int32_t count() const { return static_cast<int32_t>(start.size() - 1); }
  int32_t colour_count() const { return static_cast<int32_t>(colour_start.size() - 1); }
  int64_t entry_count() const { return entry_start.back(); }
  std::vector<std::vector<int32_t>> corner_sets() const;  ///< one per patch
  uint64_t byte_count() const;
};

/// A patch for each of these sets of corners, but for those that come after the limits on all
/// patches' entries (24 a corner of the depth) and on colours (64) are reached.
/// Shapes: at most kPatchCornersMax corners a set, rising.
Patches make_patches(const SparseGrid& finest, std::span<const std::vector<int32_t>> sets);

}  // namespace burnish
