#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// A patch has at most this many corners: its factor must fit into a CUDA block's shared memory.
inline constexpr int kPatchCornersMax = 120;

/// Small parts of the finest depth that are relaxed as a whole. The smoother's cells and the coarse
/// functions are slow there. sheets/small_components.h and tuning/slow_spots.h find them.
///
/// Patches of one colour have no cell in common, so none reads what another writes.
struct Patches {
  std::vector<int32_t> start = {0};         ///< patches + 1, into `corner`
  std::vector<int32_t> corner;              ///< rising within a patch
  std::vector<int32_t> colour_start = {0};  ///< colours + 1, into the patches
  std::vector<int64_t> entry_start = {0};   ///< patches + 1; the patches' lower triangles, by rows

  int32_t count() const { return static_cast<int32_t>(start.size() - 1); }
  int32_t colour_count() const { return static_cast<int32_t>(colour_start.size() - 1); }
  int64_t entry_count() const { return entry_start.back(); }
  std::vector<std::vector<int32_t>> corner_sets() const;  ///< one per patch
  uint64_t byte_count() const;
};

/// Makes a patch of each set of corners. All patches have at most 24 entries per corner of the
/// depth, and at most 64 colours; sets beyond these limits are left out. `was_left_out`, if given:
/// one per set. Shapes: at most kPatchCornersMax corners per set, rising.
Patches make_patches(const SparseGrid& finest, std::span<const std::vector<int32_t>> sets,
                     std::vector<char>* was_left_out = nullptr);

}  // namespace burnish
