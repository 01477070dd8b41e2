// In builds with CUDA; no device is needed.

#include "server/solver/cuda/row_groups.h"

#include <gtest/gtest.h>

#include "common/mesh/generate.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/packed.h"

namespace burnish::cuda {
namespace {

constexpr int kSliceRows = 32;

/// Every entry's place in its group's tile stands for its column.
void expect_columns(const Stencil& stencil, const RowGroups& groups) {
  const std::vector<int64_t> starts = slice_starts(stencil);
  const auto n = static_cast<int32_t>(stencil.mask.size());
  for (int32_t i = 0; i < n; ++i) {
    const int32_t group = i / groups.rows, first = group * groups.rows;
    const int32_t count = std::min(groups.rows, n - first);
    ASSERT_LE(count + groups.halo_start[group + 1] - groups.halo_start[group], kTile);
    int64_t at = starts[i / kSliceRows] + i % kSliceRows;
    for (auto [k, end] = stencil.row(i); k < end; ++k, at += kSliceRows) {
      const int32_t local = groups.local[at];
      const int32_t column =
          local < count ? first + local : groups.halo[groups.halo_start[group] + local - count];
      ASSERT_EQ(column, stencil.column[k]) << "row " << i;
    }
  }
}

TEST(RowGroups, OfAScanHaveFourSlicesAndFindEveryColumn) {
  const auto prepared =
      prepare(generate_scan({.kind = "tablet", .vertices = 20000}).value(), {.depth = 7}).value();
  const auto hierarchy = make_hierarchy(*prepared);
  for (const HierarchyDepth& depth : hierarchy->depths) {
    const RowGroups groups = make_row_groups(depth.stencil, slice_starts(depth.stencil));
    EXPECT_EQ(groups.rows, 4 * kSliceRows);
    expect_columns(depth.stencil, groups);
  }
}

// No scan has such rows; a tile would not hold the columns of four slices.
TEST(RowGroups, OfRowsThatShareNoColumnsHaveOneSlice) {
  constexpr int32_t kRows = 256, kEntries = 26;
  Stencil stencil;
  stencil.row_start = {0};
  for (int32_t i = 0; i < kRows; ++i) {
    stencil.corner_of_row.push_back(i);
    stencil.row_of_corner.push_back(i);
    stencil.mask.push_back((1u << kEntries) - 1);
    for (int32_t k = 0; k < kEntries; ++k) stencil.column.push_back(kRows + kEntries * i + k);
    stencil.row_start.push_back(static_cast<int64_t>(stencil.column.size()));
  }
  const RowGroups groups = make_row_groups(stencil, slice_starts(stencil));
  EXPECT_EQ(groups.rows, kSliceRows);
  expect_columns(stencil, groups);
}

}  // namespace
}  // namespace burnish::cuda
