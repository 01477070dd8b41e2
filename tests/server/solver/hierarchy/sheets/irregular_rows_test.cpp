#include "server/solver/hierarchy/sheets/irregular_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/solver/hierarchy/small_grids.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// A cell's numbers: the 7 pairs of its corner 0 are 0 to 6, 6 more of 1 are 7 to 12, of 2 13 to 17,
// of 3 18 to 21, of 4 22 to 24, of 5 25 and 26, and (6, 7) is 27. Row sums are 28 to 35. The second
// cell's numbers begin at 36, and two cells' ties at 72.

/// Finds the rows of these corners of a grid.
struct Found {
  Found(const SparseGrid& grid, const std::vector<CellTie>& ties,
        std::initializer_list<int32_t> irregular) {
    std::vector<uint32_t> mask(grid.corners.size(), 1);
    for (const int32_t corner : irregular) mask[corner] = 0;
    rows = find_irregular_rows(grid, ties, mask, columns);
  }

  IrregularRows rows;
  IrregularColumns columns;
};

/// Returns cells that share no corner: the first has 0 to 7, the second 8 to 15.
SparseGrid two_loose_cells() {
  SparseGrid grid;
  grid.cells = {cell_at(0, 0, 0), cell_at(2, 0, 0)};
  grid.cell_corners = {corners_from(0), corners_from(8)};
  grid.corners.resize(16);
  return grid;
}

TEST(IrregularRowsTest, AreNoneInAnEmptyGrid) {
  const Found found(SparseGrid(), {}, {});
  EXPECT_EQ(found.rows.count(), 0);
  EXPECT_THAT(found.rows.sum_start, ElementsAre(0));
  EXPECT_THAT(found.columns.start, ElementsAre(0));
}

TEST(IrregularRowsTest, AreNoneWhereSlotsDescribeEveryRow) {
  const Found found(two_cells_with_a_common_face(), {}, {});
  EXPECT_EQ(found.rows.count(), 0);
  EXPECT_THAT(found.rows.source, IsEmpty());
}

// Corner 0 of A has its pairs (0, 1) to (0, 7), which are numbers 0 to 6, and row sum 28.
TEST(IrregularRowsTest, ACornerOfOneCellHasItsPairsAndItsRowSum) {
  const Found found(two_cells_with_a_common_face(), {}, {0});
  EXPECT_THAT(found.rows.corner, ElementsAre(0));
  EXPECT_THAT(found.columns.start, ElementsAre(0, 7));
  EXPECT_THAT(found.columns.column, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(found.rows.sum_start, ElementsAre(0, 8));
  EXPECT_THAT(found.rows.source_start, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
  EXPECT_THAT(found.rows.source, ElementsAre(0, 1, 2, 3, 4, 5, 6, 28));
}

// Corner 1 is 1 of A and 0 of B. So its neighbours on the face, 3, 5 and 7, are 3, 5 and 7 of A and
// 2, 4 and 6 of B. Each of these entries is a sum of two numbers, and so is the row sum.
TEST(IrregularRowsTest, EntriesOnACommonFaceAreSumsOverBothCells) {
  const Found found(two_cells_with_a_common_face(), {}, {1});
  EXPECT_THAT(found.columns.column, ElementsAre(0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_THAT(found.rows.source, ElementsAre(0,           // column 0: (0, 1) of A
                                             7,           // 2: (1, 2) of A
                                             8, 36 + 1,   // 3: (1, 3) of A, (0, 2) of B
                                             9,           // 4
                                             10, 36 + 3,  // 5: (1, 5) of A, (0, 4) of B
                                             11,          // 6
                                             12, 36 + 5,  // 7: (1, 7) of A, (0, 6) of B
                                             36 + 0,      // 8: (0, 1) of B
                                             36 + 2,      // 9: (0, 3) of B
                                             36 + 4,      // 10: (0, 5) of B
                                             36 + 6,      // 11: (0, 7) of B
                                             29, 36 + 28));
  EXPECT_THAT(found.rows.source_start, ElementsAre(0, 1, 2, 4, 5, 7, 8, 10, 11, 12, 13, 14, 16));
}

// The tie couples corner 7 of the first cell to corner 0 of the second, which is 8: number 72 + 8 ·
// 7 + 0 = 128. Both rows have it as an entry and in their row sum.
TEST(IrregularRowsTest, ATieIsAnEntryOfTheRowsAtBothEnds) {
  const Found found(two_loose_cells(), {{0, 1, 1 << 7, 1 << 0}}, {7, 8});
  EXPECT_THAT(found.rows.corner, ElementsAre(7, 8));
  EXPECT_THAT(found.columns.start, ElementsAre(0, 8, 16));
  EXPECT_THAT(found.columns.column,
              ElementsAre(0, 1, 2, 3, 4, 5, 6, 8, 7, 9, 10, 11, 12, 13, 14, 15));
  EXPECT_THAT(found.rows.sum_start, ElementsAre(0, 9, 18));
  EXPECT_THAT(found.rows.source,
              ElementsAre(6, 12, 17, 21, 24, 26, 27, 128, 28 + 7, 128,  // row 7: (0, 7), (1, 7) ...
                          128, 36, 37, 38, 39, 40, 41, 42, 36 + 28, 128));
}

// First corners 1 and 3, second corner 2, which is 10: numbers 72 + 8 + 2 = 82 and 72 + 24 + 2
// = 98.
TEST(IrregularRowsTest, ATieCouplesOnlyTheCornersThatHaveAPartInIt) {
  const Found found(two_loose_cells(), {{0, 1, 1 << 1 | 1 << 3, 1 << 2}}, {1, 3, 10});
  EXPECT_THAT(found.columns.start, ElementsAre(0, 8, 16, 25));
  const std::vector<int32_t> last_row(found.columns.column.begin() + 16,
                                      found.columns.column.end());
  EXPECT_THAT(last_row, ElementsAre(1, 3, 8, 9, 11, 12, 13, 14, 15));
  // Corner 2 of the second cell: the tie, (0, 2), (1, 2), (2, 3) to (2, 7), then the row sum.
  const std::vector<int32_t> last_sources(found.rows.source.end() - 12, found.rows.source.end());
  EXPECT_THAT(last_sources, ElementsAre(82, 98, 36 + 1, 36 + 7, 36 + 13, 36 + 14, 36 + 15, 36 + 16,
                                        36 + 17, 36 + 28 + 2, 82, 98));
}

// Corner 1 is 1 of A and 0 of B: number 72 + 8 · 1 + 0 = 80. It is not an entry, but N and its
// transpose both add to the row sum.
TEST(IrregularRowsTest, ATieOfACornerToItselfCountsTwiceInTheRowSum) {
  const Found found(two_cells_with_a_common_face(), {{0, 1, 1 << 1, 1 << 0}}, {1});
  EXPECT_THAT(found.columns.column, ElementsAre(0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
  const std::vector<int32_t> row_sum(found.rows.source.begin() + found.rows.source_start[11],
                                     found.rows.source.end());
  EXPECT_THAT(row_sum, ElementsAre(29, 36 + 28, 80, 80));
}

TEST(IrregularRowsTest, CopiesTheColumnsOfACorner) {
  const Found found(two_loose_cells(), {{0, 1, 1 << 7, 1 << 0}}, {7, 8});
  std::vector<int32_t> columns(9, kNone);
  EXPECT_EQ(found.columns.copy_row(found.rows, 8, columns.data()), columns.data() + 8);
  EXPECT_THAT(columns, ElementsAre(7, 9, 10, 11, 12, 13, 14, 15, kNone));
}

}  // namespace
}  // namespace burnish
