#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/stencil.h"

namespace burnish::cuda {

/// Returns where the entries of a stencil's slices start (views.h, Rows), and the end.
std::vector<int64_t> slice_starts(const Stencil& stencil);

/// Rows in groups of whole slices. One block of threads does a group. It brings the vector's
/// numbers at its rows and columns into its own tile: first its rows, then its halo, which is the
/// other columns in rising order. For long rows this holds for the packed part (long_rows.h) only.
/// A tile has at most kTile numbers. Four slices of any scanned surface fit easily. A single slice,
/// of 32 rows of 26 neighbours, always fits.
struct RowGroups {
  int32_t rows;                     ///< in every group except the last: four slices, or one
  int32_t tile_max;                 ///< size of the largest tile
  std::vector<int32_t> halo_start;  ///< groups + 1
  std::vector<int32_t> halo;
  std::vector<uint16_t> local;  ///< one per entry of the slices
};

RowGroups make_row_groups(const Stencil& stencil, const std::vector<int64_t>& slice_starts);

}  // namespace burnish::cuda
