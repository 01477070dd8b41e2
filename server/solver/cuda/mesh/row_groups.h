#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/hierarchy/stencil.h"

namespace burnish::cuda {

/// Where the entries of a stencil's slices start (views.h, Rows), and one more.
std::vector<int64_t> slice_starts(const Stencil& stencil);

/// Rows in groups of whole slices, each done by one block of threads, which brings the vector's
/// numbers at its rows and their columns into a tile of its own: first those of its rows, then its
/// halo, the other columns in rising order. Of long rows that is so for the packed part
/// (long_rows.h), of which alone is spoken here. A tile holds no more than kTile: four slices of
/// any scanned surface fit by far, and a single slice, of 32 rows of 26 neighbours, always does.
struct RowGroups {
  int32_t rows;                     ///< of every group but the last: four slices, or one
  int32_t tile_max;                 ///< what the largest tile holds
  std::vector<int32_t> halo_start;  ///< groups + 1
  std::vector<int32_t> halo;
  std::vector<uint16_t> local;  ///< one per entry of the slices
};

RowGroups make_row_groups(const Stencil& stencil, const std::vector<int64_t>& slice_starts);

}  // namespace burnish::cuda
