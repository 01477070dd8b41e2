#include "server/solver/hierarchy/sheets/small_components.h"

#include <algorithm>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/solver/hierarchy/patches.h"
#include "tests/server/solver/hierarchy/small_grids.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

std::vector<int32_t> numbers(int32_t first, int32_t last) {
  std::vector<int32_t> all(last - first + 1);
  std::iota(all.begin(), all.end(), first);
  return all;
}

/// Returns one sheet for each cell. A = (0, 0, 0), which has corners 0 to 7, is apart from the
/// others in its corner 7: its copy is the first number beyond all corners.
SheetCorners sheets_with_a_apart(const SparseGrid& grid) {
  SheetCorners sheets = one_sheet_per_cell(grid);
  sheets.corners[0][7] = sheets.copy_count++;
  sheets.shared = {7};
  sheets.start = {0, 2};
  sheets.copy = {7, grid.corner_count()};
  sheets.weight = {0.5f, 0.5f};
  return sheets;
}

/// Returns the patches of all small components, without those whose small component needs coarse
/// cells if asked so.
std::vector<std::vector<int32_t>> patches_on(const SparseGrid& grid, const SheetCorners& sheets,
                                             bool all = true) {
  std::vector<std::vector<int32_t>> patches;
  for (const SmallComponent& component : find_small_components(grid, sheets))
    if (all || !component.needs_coarse_cells) patches.push_back(component.patch);
  return patches;
}

/// Returns A and a row of cells along x that begins at (1, 1, 1).
SparseGrid a_and_row(int cells) {
  std::vector<MortonKey> keys = {morton_key({0, 0, 0})};
  for (int x = 1; x <= cells; ++x) keys.push_back(morton_key({x, 1, 1}));
  std::ranges::sort(keys);
  return make_finest_grid(6, keys);
}

TEST(SmallComponents, AreNoneWithoutCells) {
  EXPECT_THAT(patches_on(SparseGrid(), one_sheet_per_cell(SparseGrid())), IsEmpty());
}

TEST(SmallComponents, AreNoneWhereNoCornerIsShared) {
  const SparseGrid grid = two_cells_with_a_common_corner();
  EXPECT_THAT(patches_on(grid, one_sheet_per_cell(grid)), IsEmpty());
}

// Corners of D = (1, 1, 1) and E = (2, 1, 1) in Morton order are 7 to 18. A hangs on them in corner
// 7.
TEST(SmallComponents, ThatHangOnEachOtherAreOneAndNeedCoarseCellsWithoutALargePiece) {
  const SparseGrid grid = a_and_row(2);
  ASSERT_EQ(grid.corner_count(), 19);
  EXPECT_THAT(patches_on(grid, sheets_with_a_apart(grid)),
              ElementsAre(ElementsAreArray(numbers(0, 18))));
  EXPECT_THAT(patches_on(grid, sheets_with_a_apart(grid), false), IsEmpty());
}

// Each sheet of the cell is a piece, and both have its corners.
TEST(SmallComponents, AreOneInACellOfTwoSheets) {
  const SparseGrid grid = grid_of(2, {{0, 0, 0}});
  SheetCorners sheets;
  sheets.first_of_cell = {0, 2};
  sheets.corners = {corners_from(0), corners_from(8)};
  sheets.copy_count = 16;
  sheets.shared = numbers(0, 7);
  sheets.start = {0, 2, 4, 6, 8, 10, 12, 14, 16};
  for (int32_t corner = 0; corner < 8; ++corner)
    sheets.copy.insert(sheets.copy.end(), {corner, 8 + corner});
  EXPECT_THAT(patches_on(grid, sheets), ElementsAre(ElementsAreArray(numbers(0, 7))));
}

// 30 cells have 31 · 4 = 124 corners, more than a patch. D is the first of them. A hangs on it in
// corner 7; A and D are around it.
TEST(SmallComponents, AreAPieceWithTheCellsAroundTheCornerInWhichItHangs) {
  static_assert(kPatchCornersMax == 120);
  const SparseGrid grid = a_and_row(30);
  ASSERT_EQ(grid.corner_count(), 7 + 124);
  const auto components = patches_on(grid, sheets_with_a_apart(grid));
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components[0].size(), 15u);  // A and D
  EXPECT_EQ(patches_on(grid, sheets_with_a_apart(grid), false), components);
}

TEST(SmallComponents, FollowTheSurfaceOnWhichTheyHang) {
  const SparseGrid grid = a_and_row(30);
  const SheetCorners sheets = sheets_with_a_apart(grid);
  EXPECT_THAT(find_anchors(find_small_components(grid, sheets), sheets), ElementsAre(7));
}

// The row's last cell is F; G touches neither and hangs on A.
TEST(SmallComponents, FollowTheSurfaceOnWhichTheirNeighbourHangs) {
  const SparseGrid grid = a_and_row(30);
  SheetCorners sheets = sheets_with_a_apart(grid);
  const int32_t of_g = sheets.copy_count;
  sheets.cell.push_back(grid.cells[0]);
  sheets.corners.push_back(corners_from(of_g));
  sheets.copy_count += kCornersPerCell;
  sheets.shared.insert(sheets.shared.begin(), 0);
  sheets.copy.insert(sheets.copy.begin(), {0, of_g});
  sheets.weight.insert(sheets.weight.begin(), {0.5f, 0.5f});
  sheets.start = {0, 2, 4};
  const std::vector<SmallComponent> a_and_g = {{{0, 1, 2, 3, 4, 5, 6, grid.corner_count()}, {}, {}},
                                               {numbers(of_g, of_g + 7), {}, {}}};
  EXPECT_THAT(find_anchors(a_and_g, sheets), ElementsAre(7, 7));
  EXPECT_THAT(find_anchors(std::span(a_and_g).last(1), sheets), ElementsAre(0));
}

TEST(SmallComponents, ThatHangOnNothingFollowNothing) {
  const SparseGrid grid = a_and_row(30);
  const std::vector<SmallComponent> a = {{{0, 1, 2, 3, 4, 5, 6}, {}, {}}};
  EXPECT_THAT(find_anchors(a, one_sheet_per_cell(grid)), ElementsAre(kNone));
}

// 28 cells have 29 · 4 = 116 corners, and A would add 7: 123 are too many for a patch.
TEST(SmallComponents, APieceIsAloneWhereItsSurroundingsAreTooMany) {
  const SparseGrid grid = a_and_row(28);
  const auto components = patches_on(grid, sheets_with_a_apart(grid));
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].size(), 15u);
  EXPECT_EQ(components[1], numbers(7, 122));
}

// A row of 40 cells from (1, 1, 1) to (40, 1, 1), and one more cell at each end. The row has the 41
// · 4 = 164 corners from 7 on. It is visited twice: from either end it has too many.
TEST(SmallComponents, ALargePieceIsNoneFromWhicheverEnd) {
  std::vector<MortonKey> keys = {morton_key({0, 0, 0}), morton_key({41, 2, 2})};
  for (int x = 1; x <= 40; ++x) keys.push_back(morton_key({x, 1, 1}));
  std::ranges::sort(keys);
  const SparseGrid grid = make_finest_grid(6, keys);
  SheetCorners sheets = sheets_with_a_apart(grid);
  const int32_t last = grid.find_cell({41, 2, 2}), last_of_row = grid.find_cell({40, 1, 1});
  const int32_t far_corner = grid.cell_corners[last][0];
  sheets.corners[last_of_row][7] = sheets.copy_count;
  sheets.shared.push_back(far_corner);
  sheets.copy.insert(sheets.copy.end(), {far_corner, sheets.copy_count++});
  sheets.start.push_back(4);
  const auto components = patches_on(grid, sheets);
  ASSERT_EQ(components.size(), 2u);
  EXPECT_EQ(components[0].size(), 15u);
  EXPECT_EQ(components[1].size(), 15u);
}

}  // namespace
}  // namespace burnish
