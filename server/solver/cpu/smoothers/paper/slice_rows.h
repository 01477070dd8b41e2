#pragma once

#include <cstdint>
#include <vector>

#include "server/solver/cpu/cpu_depth.h"

namespace burnish::cpu {

/// S with its rows in slices: a slice has the corners of one coordinate along the axis with most
/// slices. Corners keep their order within a slice. A corner's neighbours are in its own slice and
/// the two next to it.
struct SliceRows {
  std::vector<int32_t> slice_start;  ///< slices + 1, places
  std::vector<int32_t> corner;       ///< the corner at each place
  std::vector<int64_t> row_start;    ///< places + 1
  std::vector<int32_t> column;       ///< the place of each neighbour
  std::vector<float> entry;
  std::vector<float> diagonal;
  std::vector<float> inverse_diagonal;

  explicit SliceRows(const HierarchyDepth& topology);
  void read(const CpuDepth& depth);  ///< call after a new matrix

  int slice_count() const { return static_cast<int>(slice_start.size()) - 1; }
  uint64_t byte_count() const;
};

/// The slices of one thread: [first, last).
struct SliceRange {
  int first;
  int last;
};

/// Splits all slices into at most `count` ranges with about as many corners in each.
std::vector<SliceRange> partition_slices(const SliceRows& rows, int count);

}  // namespace burnish::cpu
