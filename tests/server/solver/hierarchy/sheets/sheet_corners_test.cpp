#include "server/solver/hierarchy/sheets/sheet_corners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/grid/stencil_slots.h"
#include "server/solver/hierarchy/cell_matrix.h"
#include "tests/server/solver/hierarchy/small_grids.h"

namespace burnish {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

/// The parts of a prepared mesh that find_sheet_corners() reads.
class SheetCornersTest : public testing::Test {
 protected:
  /// Sets cells of one sheet, without passages and without energy.
  void set_grid(const SparseGrid& grid) {
    grid_ = grid;
    passages_.assign(grid.cells.size(), 0);
    integrals_.assign(grid.cells.size(), CellIntegrals{});
  }

  SheetCorners find() {
    prepared_.passages = passages_;
    prepared_.integrals = integrals_;
    prepared_.sheets = sheets_;
    sheet_integrals_.resize(sheets_.size(), CellIntegrals{});
    prepared_.sheet_integrals = sheet_integrals_;
    return find_sheet_corners(prepared_, grid_);
  }

  static uint32_t passage(int dx, int dy, int dz) { return 1u << slot_of_offset(dx, dy, dz); }

  SparseGrid grid_;
  PreparedMesh prepared_;
  std::vector<uint32_t> passages_;
  std::vector<CellIntegrals> integrals_, sheet_integrals_;
  std::vector<CellSheet> sheets_;
};

TEST_F(SheetCornersTest, NoCellsHaveNoSheets) {
  const SheetCorners found = find();
  EXPECT_THAT(found.first_of_cell, ElementsAre(0));
  EXPECT_THAT(found.start, ElementsAre(0));
  EXPECT_THAT(found.shared, IsEmpty());
  EXPECT_EQ(found.copy_count, 0);
}

TEST_F(SheetCornersTest, CellsWithAPassageShareTheCornersOfTheirFace) {
  set_grid(two_cells_with_a_common_face());
  passages_ = {passage(1, 0, 0), passage(-1, 0, 0)};
  const SheetCorners found = find();
  EXPECT_THAT(found.shared, IsEmpty());
  EXPECT_THAT(found.start, ElementsAre(0));
  EXPECT_EQ(found.copy_count, 12);
  EXPECT_THAT(found.first_of_cell, ElementsAre(0, 1, 2));
  EXPECT_THAT(found.source, ElementsAre(0, 1));
  EXPECT_THAT(found.corners, ElementsAre(ElementsAre(0, 1, 2, 3, 4, 5, 6, 7),
                                         ElementsAre(1, 8, 3, 9, 5, 10, 7, 11)));
  EXPECT_FALSE(found.has_several(0));
}

// B is at side 0, 2, 4 and 6 of corners 1, 3, 5 and 7, and A at the next side of each: B comes
// first and keeps them. A's copies follow the 12 corners.
TEST_F(SheetCornersTest, CellsWithoutAPassageHaveCopiesOfTheCornersOfTheirFace) {
  set_grid(two_cells_with_a_common_face());
  const SheetCorners found = find();
  EXPECT_THAT(found.shared, ElementsAre(1, 3, 5, 7));
  EXPECT_THAT(found.start, ElementsAre(0, 2, 4, 6, 8));
  EXPECT_THAT(found.copy, ElementsAre(1, 12, 3, 13, 5, 14, 7, 15));
  EXPECT_EQ(found.copy_count, 16);
  EXPECT_THAT(found.corners, ElementsAre(ElementsAre(0, 12, 2, 13, 4, 14, 6, 15),
                                         ElementsAre(1, 8, 3, 9, 5, 10, 7, 11)));
  EXPECT_THAT(found.weight, Each(0.5f));  // equal without energy
}

TEST_F(SheetCornersTest, APassageOfOneCellAloneJoinsNothing) {
  set_grid(two_cells_with_a_common_corner());
  passages_ = {passage(1, 1, 1), 0};
  EXPECT_THAT(find().shared, ElementsAre(7));
  passages_ = {0, passage(-1, -1, -1)};
  EXPECT_THAT(find().shared, ElementsAre(7));
}

// Corner 7 is at side 0 of D and at side 7 of A: D keeps it, A's copy follows the 15 corners.
TEST_F(SheetCornersTest, CellsThatMeetInACornerWithoutHangingTogetherHaveACopyEach) {
  set_grid(two_cells_with_a_common_corner());
  const SheetCorners found = find();
  EXPECT_THAT(found.shared, ElementsAre(7));
  EXPECT_THAT(found.start, ElementsAre(0, 2));
  EXPECT_THAT(found.copy, ElementsAre(7, 15));
  EXPECT_EQ(found.copy_count, 16);
  EXPECT_THAT(found.corners, ElementsAre(ElementsAre(0, 1, 2, 3, 4, 5, 6, 15),
                                         ElementsAre(7, 8, 9, 10, 11, 12, 13, 14)));
}

TEST_F(SheetCornersTest, CellsThatHangTogetherAtACornerShareIt) {
  set_grid(two_cells_with_a_common_corner());
  passages_ = {passage(1, 1, 1), passage(-1, -1, -1)};
  const SheetCorners found = find();
  EXPECT_THAT(found.shared, IsEmpty());
  EXPECT_EQ(found.corners[0][7], 7);
}

// E = (0, 1, 0) touches A = (0, 0, 0) and B = (1, 0, 0) along y = 1 only. At y = 0 A and B have no
// passage to each other and hang together only through E: the surface bends around the edge there.
TEST_F(SheetCornersTest, CellsThatHangTogetherByOneNearbyShareTheirCorners) {
  set_grid(grid_of(2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  const uint32_t from_a = passage(0, 1, 0), from_b = passage(-1, 1, 0);
  const uint32_t from_e = passage(0, -1, 0) | passage(1, -1, 0);
  passages_ = {from_a, from_b, from_e};
  EXPECT_THAT(find().shared, IsEmpty());
  // Without E's passage to A, A is apart from both. Its face to B has corners 1, 3, 5 and 7, its
  // face to E has 2, 3, 6 and 7.
  passages_ = {from_a, from_b, passage(1, -1, 0)};
  EXPECT_THAT(find().shared, ElementsAre(1, 2, 3, 5, 6, 7));
}

// All corners exist twice: the first sheet has the grid's corners, the second copies 8 to 15.
TEST_F(SheetCornersTest, TwoSheetsInACellHaveEightCornersEach) {
  set_grid(grid_of(2, {{0, 0, 0}}));
  sheets_ = {{0, 5, 0}, {0, 9, 0}};
  const SheetCorners found = find();
  EXPECT_TRUE(found.has_several(0));
  EXPECT_THAT(found.first_of_cell, ElementsAre(0, 2));
  EXPECT_THAT(found.source, ElementsAre(1, 2));  // one cell, and sheets 0 and 1 after it
  EXPECT_THAT(found.shared, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(found.corners, ElementsAre(corners_from(0), corners_from(8)));
  EXPECT_EQ(found.copy_count, 16);
}

// At corners 0 and 1 the sheets have energies 3 = -(-3) and 1 = -(-1), at the others none.
TEST_F(SheetCornersTest, CopiesAreWeighedByTheirEnergyAtTheCorner) {
  set_grid(grid_of(2, {{0, 0, 0}}));
  sheets_ = {{0, 5, 0}, {0, 9, 0}};
  sheet_integrals_.assign(2, CellIntegrals{});
  sheet_integrals_[0].stiffness[0][pair_index(0, 1)] = -3;
  sheet_integrals_[1].stiffness[1][pair_index(0, 1)] = -1;
  const SheetCorners found = find();
  std::vector<float> expected(16, 0.5f);
  expected[0] = expected[2] = 0.75f;
  expected[1] = expected[3] = 0.25f;
  EXPECT_EQ(found.weight, expected);
}

// B hangs together with the one sheet of A that leads to it. The other sheet has eight copies.
TEST_F(SheetCornersTest, ANeighbourHangsTogetherWithTheSheetThatLeadsToIt) {
  set_grid(two_cells_with_a_common_face());
  passages_ = {passage(1, 0, 0), passage(-1, 0, 0)};
  sheets_ = {{0, 5, passage(1, 0, 0)}, {0, 9, 0}};
  const SheetCorners found = find();
  EXPECT_THAT(found.source, ElementsAre(2, 3, 1));
  EXPECT_THAT(found.shared, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(found.corners, ElementsAre(corners_from(0), corners_from(12),
                                         ElementsAre(1, 8, 3, 9, 5, 10, 7, 11)));
}

// Components 5 and 9 both pass through A and B. Each corner i of 12 has a second copy, 12 + i.
TEST_F(SheetCornersTest, SheetsOfDifferentComponentsNeverHangTogether) {
  set_grid(two_cells_with_a_common_face());
  passages_ = {passage(1, 0, 0), passage(-1, 0, 0)};
  sheets_ = {
      {0, 5, passages_[0]}, {0, 9, passages_[0]}, {1, 5, passages_[1]}, {1, 9, passages_[1]}};
  const SheetCorners found = find();
  EXPECT_EQ(found.copy_count, 24);
  EXPECT_THAT(found.corners,
              ElementsAre(corners_from(0), corners_from(12), ElementsAre(1, 8, 3, 9, 5, 10, 7, 11),
                          ElementsAre(13, 20, 15, 21, 17, 22, 19, 23)));
}

TEST(OneSheetPerCell, HasTheCornersOfTheGrid) {
  const SparseGrid grid = two_cells_with_a_common_corner();
  const SheetCorners whole = one_sheet_per_cell(grid);
  EXPECT_THAT(whole.first_of_cell, ElementsAre(0, 1, 2));
  EXPECT_THAT(whole.source, ElementsAre(0, 1));
  EXPECT_EQ(whole.cell, grid.cells);
  EXPECT_THAT(whole.corners, ElementsAre(corners_from(0), corners_from(7)));
  EXPECT_EQ(whole.copy_count, 15);
  EXPECT_THAT(whole.shared, IsEmpty());
  EXPECT_THAT(whole.start, ElementsAre(0));
}

TEST(OneSheetPerCell, IsNoneWithoutCells) {
  const SheetCorners whole = one_sheet_per_cell(SparseGrid());
  EXPECT_THAT(whole.first_of_cell, ElementsAre(0));
  EXPECT_THAT(whole.source, IsEmpty());
}

}  // namespace
}  // namespace burnish
