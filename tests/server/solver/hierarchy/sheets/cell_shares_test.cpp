#include "server/solver/hierarchy/sheets/cell_shares.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/solver/hierarchy/half_way.h"
#include "tests/server/solver/hierarchy/small_grids.h"

namespace burnish {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::FieldsAre;
using testing::IsEmpty;

// A CellTie is (first, second, first's corners, second's), a CellShare (source, left, right, is
// transposed), a CellPart (weights, places). Parts 0 to 7 belong to octants; others follow.

/// Returns coarse cells with these corners, and the parents of the finer cells or sheets.
CoarseGrid coarse_cells(std::vector<CellCorners> cell_corners, std::vector<int32_t> parent_cell) {
  CoarseGrid coarse;
  coarse.grid.cells.resize(cell_corners.size());
  coarse.grid.cell_corners = std::move(cell_corners);
  coarse.parent_cell = std::move(parent_cell);
  return coarse;
}

/// Returns one sheet for each cell; D has the first copy of corner 7, A the second.
SheetCorners sheets_apart_in_corner_7(const SparseGrid& grid) {
  SheetCorners sheets = one_sheet_per_cell(grid);
  sheets.corners[0][7] = 15;
  sheets.copy_count = 16;
  sheets.shared = {7};
  sheets.start = {0, 2};
  sheets.copy = {7, 15};
  sheets.weight = {0.25f, 0.75f};
  return sheets;
}

TEST(SharesOfCells, AreNoneWithoutCells) {
  const TiesAndShares found =
      share_cells(SparseGrid(), one_sheet_per_cell(SparseGrid()), CoarseGrid());
  EXPECT_THAT(found.ties, IsEmpty());
  EXPECT_THAT(found.shares.start, ElementsAre(0));
  EXPECT_THAT(found.shares.apart, IsEmpty());
}

// Octant 1 of a cell begins at x = 1: its corners' places are x + 3y + 9z of (1 or 2, y, z). Octant
// 7 begins in the middle, at place 13, and ends at 26.
TEST(SharesOfCells, BeginWithThePartsOfTheOctants) {
  const SparseGrid grid = two_cells_with_a_common_face();
  const TiesAndShares found =
      share_cells(grid, one_sheet_per_cell(grid), coarse_cells({corners_from(0)}, {0, 0}));
  ASSERT_EQ(found.shares.part.size(), 8u);
  EXPECT_THAT(found.shares.part[1], FieldsAre(Each(1), ElementsAre(1, 2, 4, 5, 10, 11, 13, 14)));
  EXPECT_EQ(found.shares.part[7].place[0], 13);
  EXPECT_EQ(found.shares.part[7].place[7], 26);
}

TEST(SharesOfCells, AreNoneWhereEachCornerHasOneCopy) {
  const SparseGrid grid = two_cells_with_a_common_face();
  const TiesAndShares found =
      share_cells(grid, one_sheet_per_cell(grid), coarse_cells({corners_from(0)}, {0, 0}));
  EXPECT_THAT(found.ties, IsEmpty());
  EXPECT_THAT(found.shares.target, IsEmpty());
  EXPECT_THAT(found.shares.start, ElementsAre(0));
  EXPECT_THAT(found.shares.apart, IsEmpty());
}

// A = (0, 0, 0) and D = (1, 1, 1) lie in one place and meet in its middle without hanging together.
// So they have the parents 0 and 1. Corner 7 is the mean of both: 1/4 of D's copy and 3/4 of A's.
// A's part of parent 0 (number 8) has weight 1, except 3/4 at its corner 7. A's part of parent 1
// (9) has only 1/4 there. D's part of parent 1 (10) has 1/4 at its corner 0. D's part of parent 0
// (11) has 3/4 there.
class SheetsThatMeetInACorner : public testing::Test {
 protected:
  SheetsThatMeetInACorner() {
    const SparseGrid grid = two_cells_with_a_common_corner();
    CoarseGrid coarse = coarse_cells({corners_from(0), corners_from(8)}, {0, 1});
    coarse.from.resize(16);
    coarse.from[7] = {1, 13};
    coarse.from[15] = {0, 13};
    found_ = share_cells(grid, sheets_apart_in_corner_7(grid), coarse);
  }

  TiesAndShares found_;
};

TEST_F(SheetsThatMeetInACorner, HaveAPartOfEachParent) {
  const std::vector<CellPart>& part = found_.shares.part;
  ASSERT_EQ(part.size(), 12u);
  EXPECT_THAT(part[8], FieldsAre(ElementsAre(1, 1, 1, 1, 1, 1, 1, 0.75f),
                                 ElementsAre(0, 1, 3, 4, 9, 10, 12, 13)));
  EXPECT_THAT(part[9].weight, ElementsAre(0, 0, 0, 0, 0, 0, 0, 0.25f));
  EXPECT_EQ(part[9].place[7], 13);
  EXPECT_THAT(part[10], FieldsAre(ElementsAre(0.25f, 1, 1, 1, 1, 1, 1, 1),
                                  ElementsAre(13, 14, 16, 17, 22, 23, 25, 26)));
  EXPECT_THAT(part[11].weight, ElementsAre(0.75f, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_EQ(part[11].place[0], 13);
}

// The middle of a cell takes from all its corners.
TEST_F(SheetsThatMeetInACorner, TieTheirParents) {
  EXPECT_THAT(found_.ties, ElementsAre(FieldsAre(0, 1, 0xff, 0xff)));
}

// Targets: parents 0 and 1, and the tie, which is number 2 after them. The parts of the tie are in
// the order of its parents: D's share is (11, 10), but D came with (10, 11), hence the transpose.
TEST_F(SheetsThatMeetInACorner, GiveSharesToBothParentsAndTheTie) {
  const CellShares& shares = found_.shares;
  EXPECT_THAT(shares.target, ElementsAre(0, 1, 2));
  EXPECT_THAT(shares.start, ElementsAre(0, 2, 4, 6));
  EXPECT_THAT(shares.share,
              ElementsAre(FieldsAre(0, 8, 8, 0), FieldsAre(1, 11, 11, 0), FieldsAre(0, 9, 9, 0),
                          FieldsAre(1, 10, 10, 0), FieldsAre(0, 8, 9, 0), FieldsAre(1, 11, 10, 1)));
}

TEST_F(SheetsThatMeetInACorner, AreNoPlainChildren) {
  EXPECT_THAT(found_.shares.apart, ElementsAre(0, 1));
}

// Now the parents of A and D are joined in the corner, by cells that are not here: it is corner 7
// of the first and 0 of the second. Both give the same value, so each cell keeps its own parent,
// with weight 1.
TEST(SharesOfCells, MakeNoTieWhereBothParentsSayTheSame) {
  const SparseGrid grid = two_cells_with_a_common_corner();
  CoarseGrid coarse = coarse_cells({corners_from(0), corners_from(7)}, {0, 1});
  coarse.from.resize(16);
  coarse.from[7] = {1, 0};
  coarse.from[15] = {0, 26};
  SheetCorners sheets = sheets_apart_in_corner_7(grid);
  sheets.cell = {cell_at(1, 1, 1),
                 cell_at(2, 2, 2)};  // the last child of one, the first of another
  const TiesAndShares found = share_cells(grid, sheets, coarse);
  EXPECT_THAT(found.ties, IsEmpty());
  EXPECT_THAT(found.shares.target, ElementsAre(0, 1));
  EXPECT_THAT(found.shares.share, ElementsAre(FieldsAre(0, 8, 8, 0), FieldsAre(1, 9, 9, 0)));
  EXPECT_THAT(found.shares.part[8].weight, Each(1));
  EXPECT_THAT(found.shares.part[9].weight, Each(1));
}

// A cell with two sheets; each of its corners is the mean of two copies, one of each parent. The
// numbers of sheets 0 and 1 are 1 and 2, after the only cell's. Each takes half of all corners from
// parent 0 (parts 8 and 10), and half from parent 1 (9 and 11).
TEST(SharesOfCells, TieTheParentsOfTwoSheetsInACell) {
  const SparseGrid grid = grid_of(2, {{0, 0, 0}});
  SheetCorners sheets;
  sheets.first_of_cell = {0, 2};
  sheets.cell = {grid.cells[0], grid.cells[0]};
  sheets.source = {1, 2};
  sheets.corners = {corners_from(0), corners_from(8)};
  sheets.copy_count = 16;
  sheets.start = {0};
  CoarseGrid coarse = coarse_cells({corners_from(0), corners_from(8)}, {0, 1});
  coarse.from.resize(16);
  for (int32_t a = 0; a < kCornersPerCell; ++a) {
    sheets.shared.push_back(a);
    sheets.start.push_back(2 * a + 2);
    sheets.copy.insert(sheets.copy.end(), {a, 8 + a});
    sheets.weight.insert(sheets.weight.end(), {0.5f, 0.5f});
    coarse.from[a] = {0, place_in_parent(grid.cells[0], a)};
    coarse.from[8 + a] = {1, place_in_parent(grid.cells[0], a)};
  }
  const TiesAndShares found = share_cells(grid, sheets, coarse);
  EXPECT_THAT(found.ties, ElementsAre(FieldsAre(0, 1, 0xff, 0xff)));
  EXPECT_THAT(found.shares.apart, ElementsAre(0));
  EXPECT_THAT(found.shares.target, ElementsAre(0, 1, 2));
  EXPECT_THAT(found.shares.share,
              ElementsAre(FieldsAre(1, 8, 8, 0), FieldsAre(2, 10, 10, 0), FieldsAre(1, 9, 9, 0),
                          FieldsAre(2, 11, 11, 0), FieldsAre(1, 8, 9, 0), FieldsAre(2, 10, 11, 0)));
  for (int part = 8; part < 12; ++part)
    EXPECT_THAT(found.shares.part[part].weight, Each(0.5f)) << part;
}

/// Returns fine cells (1, 0, 0) and (2, 0, 0): octant 1 of one place, octant 0 of the next.
SparseGrid cells_of_two_places() {
  SparseGrid fine;
  fine.cells = {cell_at(1, 0, 0), cell_at(2, 0, 0)};
  return fine;
}

TEST(SharesOfTies, AreNoneWithoutTies) {
  EXPECT_THAT(share_ties(SparseGrid(), {}, CoarseGrid()).shares.start, ElementsAre(0));
  const TiesAndShares found = share_ties(cells_of_two_places(), {}, coarse_cells({{}, {}}, {0, 1}));
  EXPECT_THAT(found.ties, IsEmpty());
  EXPECT_THAT(found.shares.target, IsEmpty());
  EXPECT_THAT(found.shares.apart, IsEmpty());
}

// The tie is number 2 after two cells, at both depths. It couples corner 0 of the first cell,
// half-way between its parent's corners 0 and 1, to corner 0 of the second, its parent's 0.
TEST(SharesOfTies, TieTheParentsByTheCornersThatWeighOnTheTiedOnes) {
  const std::vector<CellTie> ties = {{0, 1, 1 << 0, 1 << 0}};
  const TiesAndShares found =
      share_ties(cells_of_two_places(), ties, coarse_cells({{}, {}}, {0, 1}));
  EXPECT_THAT(found.ties, ElementsAre(FieldsAre(0, 1, 0b11, 0b1)));
  EXPECT_THAT(found.shares.target, ElementsAre(2));
  EXPECT_THAT(found.shares.start, ElementsAre(0, 1));
  EXPECT_THAT(found.shares.share, ElementsAre(FieldsAre(2, 1, 0, 0)));
}

// As in the last test, but the second cell's parent comes first.
TEST(SharesOfTies, AreTransposedWhereTheParentsAreInTheOtherOrder) {
  const std::vector<CellTie> ties = {{0, 1, 1 << 0, 1 << 0}};
  const TiesAndShares found =
      share_ties(cells_of_two_places(), ties, coarse_cells({{}, {}}, {1, 0}));
  EXPECT_THAT(found.ties, ElementsAre(FieldsAre(0, 1, 0b1, 0b11)));
  EXPECT_THAT(found.shares.share, ElementsAre(FieldsAre(2, 0, 1, 1)));
}

// Both N and its transpose couple the parent's corners.
TEST(SharesOfTies, AreAPartOfTheParentThatBothCellsHave) {
  const std::vector<CellTie> ties = {{0, 1, 1 << 0, 1 << 0}};
  const TiesAndShares found = share_ties(cells_of_two_places(), ties, coarse_cells({{}}, {0, 0}));
  EXPECT_THAT(found.ties, IsEmpty());
  EXPECT_THAT(found.shares.target, ElementsAre(0));
  EXPECT_THAT(found.shares.start, ElementsAre(0, 2));
  EXPECT_THAT(found.shares.share, ElementsAre(FieldsAre(2, 1, 0, 0), FieldsAre(2, 0, 1, 1)));
}

// Two ties between cells of the same two parents, at corner 0 of each and at corner 7. (1, 1, 1) of
// octant 1 is (2, 1, 1) of its parent, in the middle of the face of 1, 3, 5 and 7. (1, 1, 1) of
// octant 0 is in the middle of the parent.
TEST(SharesOfTies, AreOneTieForEachPairOfParents) {
  const std::vector<CellTie> ties = {{0, 1, 1 << 0, 1 << 0}, {0, 1, 1 << 7, 1 << 7}};
  const TiesAndShares found =
      share_ties(cells_of_two_places(), ties, coarse_cells({{}, {}}, {0, 1}));
  EXPECT_THAT(found.ties, ElementsAre(FieldsAre(0, 1, 0b10101011, 0xff)));
  EXPECT_THAT(found.shares.share, ElementsAre(FieldsAre(2, 1, 0, 0), FieldsAre(3, 1, 0, 0)));
}

// Nine sheets of one place that hang together nearby.
TEST(SharesOfTies, TheNinthChildOfACellIsAShare) {
  SparseGrid fine;
  fine.cells.assign(9, cell_at(1, 0, 0));
  const TiesAndShares found = share_ties(fine, {}, coarse_cells({{}}, std::vector<int32_t>(9, 0)));
  EXPECT_THAT(found.shares.apart, ElementsAre(8));
  EXPECT_THAT(found.shares.target, ElementsAre(0));
  EXPECT_THAT(found.shares.share, ElementsAre(FieldsAre(8, 1, 1, 0)));
}

}  // namespace
}  // namespace burnish
