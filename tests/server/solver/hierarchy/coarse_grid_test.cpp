#include "server/solver/hierarchy/coarse_grid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/solver/hierarchy/small_grids.h"

namespace burnish {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::IsEmpty;

constexpr CellCorners kNoCells = {kNone, kNone, kNone, kNone, kNone, kNone, kNone, kNone};

TEST(JoinSheets, OfNoCellsIsNone) {
  const CoarseGrid coarse = join_sheets(SparseGrid{.depth = 1});
  EXPECT_EQ(coarse.grid.depth, 0);
  EXPECT_THAT(coarse.grid.cells, IsEmpty());
  EXPECT_THAT(coarse.parent_cell, IsEmpty());
  EXPECT_THAT(coarse.from, IsEmpty());
}

// Corner (x, y, z) of A and B stands at place x + 3y + 9z of their parent.
TEST(JoinSheets, MakesOneCellOfCellsThatShareAParent) {
  const CoarseGrid coarse = join_sheets(two_cells_with_a_common_face());
  EXPECT_EQ(coarse.grid.depth, 1);
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(corners_from(0)));
  EXPECT_THAT(coarse.parent_cell, ElementsAre(0, 0));
  EXPECT_THAT(coarse.from,
              ElementsAre(FieldsAre(0, 0), FieldsAre(0, 1), FieldsAre(0, 3), FieldsAre(0, 4),
                          FieldsAre(0, 9), FieldsAre(0, 10), FieldsAre(0, 12), FieldsAre(0, 13),
                          FieldsAre(0, 2), FieldsAre(0, 5), FieldsAre(0, 11), FieldsAre(0, 14)));
}

// (0, 0, 0) and (3, 3, 3) share no corner: they are pieces 0 and 1. Their parents (0, 0, 0) and
// (1, 1, 1) lie in one cell of depth 0, and (1, 1, 1) is a corner of both: the last of the first
// and the first of the second, in the middle of that cell (place 13).
TEST(JoinSheets, KeepsPiecesOfSurfaceApartInOneCell) {
  const SparseGrid middle = make_parent_grid(grid_of(2, {{0, 0, 0}, {3, 3, 3}}));
  const CoarseGrid coarse = join_sheets(middle);
  EXPECT_THAT(coarse.grid.cells, ElementsAre(GridKey{0, 0}, GridKey{0, 1}));
  EXPECT_THAT(coarse.parent_cell, ElementsAre(0, 1));
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(ElementsAre(0, 2, 4, 6, 8, 10, 12, 14),
                                                    ElementsAre(1, 3, 5, 7, 9, 11, 13, 15)));
  EXPECT_THAT(coarse.from[7], FieldsAre(0, 13));
  EXPECT_THAT(coarse.from[8], FieldsAre(1, 13));
}

TEST(SheetsApart, OfNoCellsAreNone) {
  const CoarseGrid coarse = keep_sheets_apart(1, {}, {}, 0);
  EXPECT_EQ(coarse.grid.depth, 1);
  EXPECT_THAT(coarse.grid.cells, IsEmpty());
  EXPECT_THAT(coarse.grid.corners, IsEmpty());
  EXPECT_THAT(coarse.from, IsEmpty());
}

TEST(SheetsApart, HaveOneCellWhereCellsOfAPlaceShareCorners) {
  const SparseGrid fine = two_cells_with_a_common_face();
  const CoarseGrid coarse = keep_sheets_apart(1, fine.cells, fine.cell_corners, 12);
  EXPECT_THAT(coarse.parent_cell, ElementsAre(0, 0));
  EXPECT_THAT(coarse.grid.cells, ElementsAre(GridKey{0, 0}));  // at 0, the first child of cell 0
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(corners_from(0)));
  EXPECT_THAT(coarse.from[1], FieldsAre(0, 1));    // in the middle between corners 0 and 1
  EXPECT_THAT(coarse.from[11], FieldsAre(0, 14));  // (2, 1, 1)
  for (int a = 0; a < kCornersPerCell; ++a) {
    CellCorners around = kNoCells;
    around[a] = 0;
    EXPECT_EQ(coarse.grid.cells_of_corner[a], around);
  }
}

// Corner a of place 0 exists twice: 2a of the first sheet, 2a + 1 of the second.
TEST(SheetsApart, HaveACellEachWhereCellsOfAPlaceShareNoCorner) {
  const std::vector<GridKey> cells = {cell_at(0, 0, 0), cell_at(1, 0, 0)};
  const CoarseGrid coarse =
      keep_sheets_apart(1, cells, std::vector{corners_from(0), corners_from(8)}, 16);
  EXPECT_THAT(coarse.parent_cell, ElementsAre(0, 1));
  EXPECT_THAT(coarse.grid.cells, ElementsAre(GridKey{0, 0}, GridKey{0, 1}));
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(ElementsAre(0, 2, 4, 6, 8, 10, 12, 14),
                                                    ElementsAre(1, 3, 5, 7, 9, 11, 13, 15)));
  EXPECT_THAT(coarse.from[7], FieldsAre(0, 13));  // (1, 1, 1)
  EXPECT_THAT(coarse.from[8], FieldsAre(1, 1));   // (1, 0, 0)
}

// The sheets of (0, 0, 0) share no corner with each other, but each shares one with (1, 0, 0). The
// first shares its corner 1, the second its corner 3; (1, 0, 0) has them as 0 and 2.
TEST(SheetsApart, HaveOneCellWhereAThirdCellConnectsTwo) {
  const std::vector<GridKey> cells = {cell_at(0, 0, 0), cell_at(0, 0, 0), cell_at(1, 0, 0)};
  const std::vector<CellCorners> corners = {
      corners_from(0), corners_from(8), {1, 16, 11, 17, 18, 19, 20, 21}};
  const CoarseGrid coarse = keep_sheets_apart(1, cells, corners, 22);
  EXPECT_THAT(coarse.parent_cell, ElementsAre(0, 0, 0));
  EXPECT_EQ(coarse.grid.corner_count(), 8);
}

/// Cells (1, 0, 0) and (2, 0, 0), of parents (0, 0, 0) and (1, 0, 0). They share only corner a of
/// the first, which is a - 1 of the second.
CoarseGrid parents_of_cells_that_share(int a) {
  const std::vector<GridKey> cells = {cell_at(1, 0, 0), cell_at(2, 0, 0)};
  std::vector<CellCorners> corners = {corners_from(0), corners_from(8)};
  corners[1][a - 1] = a;
  return keep_sheets_apart(1, cells, corners, 16);
}

// Corner 1 of the first cell, (2, 0, 0), is corner 1 of its parent and 0 of the other parent. The
// common face has three more places, each with a corner of both parents. In the order of places: 0,
// then the common corner 1, 2, 3 twice, 4, 5 twice, 6, 7 twice; then four of the second parent
// alone.
TEST(SheetsApart, HaveOneCornerWhereTheyShareIt) {
  const CoarseGrid coarse = parents_of_cells_that_share(1);
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(ElementsAre(0, 1, 2, 3, 5, 6, 8, 9),
                                                    ElementsAre(1, 11, 4, 12, 7, 13, 10, 14)));
  EXPECT_THAT(coarse.grid.cells_of_corner[1],
              ElementsAre(1, 0, kNone, kNone, kNone, kNone, kNone, kNone));
}

// Corner 3 of the first cell, (2, 1, 0), lies between corners 1 and 3 of its parent, which are 0
// and 2 of the other. So 3 exists once as well, and all numbers after it are one less.
TEST(SheetsApart, HaveOneCornerAtEachEndOfAnEdgeInWhoseMiddleTheyShareOne) {
  const CoarseGrid coarse = parents_of_cells_that_share(3);
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(ElementsAre(0, 1, 2, 3, 4, 5, 7, 8),
                                                    ElementsAre(1, 10, 3, 11, 6, 12, 9, 13)));
}

// Two sheets of cell (1, 0, 0), and cell (2, 0, 0). The latter shares (2, 0, 0) with the first
// sheet and (2, 0, 1) with the second. (2, 0, 1) lies half-way up an edge of the parents, from (1,
// 0, 0) to (1, 0, 1) in their units. The second and the third parent share both ends; the first
// also shares the lower one. The corners in the order of places, with their parents P, Q and R: 0
// P, 1 Q; 2 PQR at place 1; 3 P, 4 Q; 5 P, 6 Q, 7 R at 3; 8 P, 9 Q; 10 P, 11 QR at 5; 12 P, 13 Q;
// 14 P, 15 Q, 16 R at 7; 17 to 20 R.
TEST(SheetsApart, HaveNoCellsAroundACornerWithTwoOnOneSide) {
  const std::vector<GridKey> cells = {cell_at(1, 0, 0), cell_at(1, 0, 0), cell_at(2, 0, 0)};
  const std::vector<CellCorners> corners = {
      corners_from(0), corners_from(8), {1, 16, 17, 18, 13, 19, 20, 21}};
  const CoarseGrid coarse = keep_sheets_apart(1, cells, corners, 22);
  EXPECT_THAT(coarse.grid.cell_corners, ElementsAre(ElementsAre(0, 2, 3, 5, 8, 10, 12, 14),
                                                    ElementsAre(1, 2, 4, 6, 9, 11, 13, 15),
                                                    ElementsAre(2, 17, 7, 18, 11, 19, 16, 20)));
  EXPECT_EQ(coarse.grid.cells_of_corner[2], kNoCells);  // corner 1 of both P and Q
  EXPECT_THAT(coarse.grid.cells_of_corner[11],
              ElementsAre(kNone, kNone, kNone, kNone, 2, 1, kNone, kNone));
}

// With more than 32 sheets in one place the code goes by corners, not by pairs of cells. The last
// of 33 shares corner 0 with the first.
TEST(SheetsApart, AreFoundInACrowdedPlaceAsWell) {
  const std::vector<GridKey> cells(33, cell_at(0, 0, 0));
  std::vector<CellCorners> corners;
  for (int32_t c = 0; c < 33; ++c) corners.push_back(corners_from(kCornersPerCell * c));
  corners[32][0] = 0;
  const CoarseGrid coarse = keep_sheets_apart(1, cells, corners, kCornersPerCell * 33);
  EXPECT_EQ(coarse.grid.cell_count(), 32);
  EXPECT_EQ(coarse.parent_cell[31], 31);
  EXPECT_EQ(coarse.parent_cell[32], 0);
}

}  // namespace
}  // namespace burnish
