// Built with CUDA only; needs no device.

#include "server/solver/cuda/mesh/row_groups.h"

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/solver/cuda/mesh/long_rows.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish::cuda {
namespace {

constexpr int kSliceRows = 32;

/// Checks that every packed entry's place in its group's tile stands for its column, and that the
/// tails have the other columns.
void expect_columns(const Stencil& stencil, const RowGroups& groups) {
  const std::vector<int64_t> starts = slice_starts(stencil);
  const LongRowTails tails = long_row_tails(stencil);
  size_t in_tails = 0;
  const auto n = static_cast<int32_t>(stencil.mask.size());
  for (int32_t i = 0; i < n; ++i) {
    const int32_t group = i / groups.rows, first = group * groups.rows;
    const int32_t count = std::min(groups.rows, n - first);
    ASSERT_LE(count + groups.halo_start[group + 1] - groups.halo_start[group], kTile);
    int64_t at = starts[i / kSliceRows] + i % kSliceRows;
    const int64_t row_end = stencil.row(i).end;
    auto [k, end] = packed_part(stencil, i);
    for (; k < end; ++k, at += kSliceRows) {
      const int32_t local = groups.local[at];
      const int32_t column =
          local < count ? first + local : groups.halo[groups.halo_start[group] + local - count];
      ASSERT_EQ(column, stencil.column[k]) << "row " << i;
    }
    if (k == row_end) continue;
    ASSERT_EQ(tails.start[i], static_cast<int32_t>(in_tails));
    ASSERT_EQ(tails.start[i + 1] - tails.start[i], row_end - k);
    for (; k < row_end; ++k) ASSERT_EQ(tails.column[in_tails++], stencil.column[k]) << "row " << i;
  }
  EXPECT_EQ(in_tails, tails.column.size());
}

/// Returns rows of `entries` entries each, all of different columns.
Stencil strangers(int32_t rows, int32_t entries) {
  Stencil stencil;
  stencil.row_start = {0};
  for (int32_t i = 0; i < rows; ++i) {
    stencil.corner_of_row.push_back(i);
    stencil.row_of_corner.push_back(i);
    stencil.mask.push_back(entries <= kEntriesMax ? (1u << entries) - 1 : 0);
    for (int32_t k = 0; k < entries; ++k) stencil.column.push_back(rows + entries * i + k);
    stencil.row_start.push_back(static_cast<int64_t>(stencil.column.size()));
  }
  return stencil;
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

TEST(RowGroups, OfATabletsCoarseDepthsHaveLongRowsBeside) {
  const auto prepared =
      prepare(generate_scan({.kind = "tablet", .vertices = 20000}).value(), {.depth = 7}).value();
  const auto hierarchy = make_hierarchy(*prepared);
  EXPECT_TRUE(long_row_tails(hierarchy->at(7).stencil).start.empty());
  EXPECT_FALSE(long_row_tails(hierarchy->at(6).stencil).column.empty());
}

// No scan has such rows: a tile would not hold the columns of four slices.
TEST(RowGroups, OfRowsThatShareNoColumnsHaveOneSlice) {
  const Stencil stencil = strangers(256, kEntriesMax);
  const RowGroups groups = make_row_groups(stencil, slice_starts(stencil));
  EXPECT_EQ(groups.rows, kSliceRows);
  expect_columns(stencil, groups);
}

TEST(RowGroups, TakeNoMoreOfARowThanASliceDoes) {
  const Stencil stencil = strangers(70, 154);
  const std::vector<int64_t> starts = slice_starts(stencil);
  EXPECT_EQ(starts.back(), 3 * kSliceRows * kEntriesMax);
  EXPECT_EQ(long_row_tails(stencil).column.size(), 70u * (154 - kEntriesMax));
  expect_columns(stencil, make_row_groups(stencil, starts));
}

}  // namespace
}  // namespace burnish::cuda
