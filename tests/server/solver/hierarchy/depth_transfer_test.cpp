#include "server/solver/hierarchy/depth_transfer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/solver/hierarchy/small_grids.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::FieldsAre;
using testing::IsEmpty;

/// Returns coarse cells with these corners; nothing follows from them yet. `corners`: their number.
CoarseGrid coarse_cells(std::vector<CellCorners> cell_corners, size_t corners) {
  CoarseGrid coarse;
  coarse.grid.cells.resize(cell_corners.size());
  coarse.grid.cell_corners = std::move(cell_corners);
  coarse.grid.corners.resize(corners);
  return coarse;
}

TEST(DepthTransferTest, OfNoCornersIsEmpty) {
  const DepthTransfer transfer = make_transfer(CoarseGrid());
  EXPECT_THAT(transfer.prolongation, IsEmpty());
  EXPECT_THAT(transfer.restriction_start, ElementsAre(0));
  EXPECT_THAT(transfer.restriction_corner, IsEmpty());
  EXPECT_EQ(transfer.shared.count(), 0);
  EXPECT_THAT(transfer.shared.start, ElementsAre(0));
}

// Fine corner 0 lies at corner 0 of the cell, 1 between 0 and 1 (place 1), 2 in the middle (13). So
// corner 0 gathers all three, corner 1 the last two, and the others only the last.
TEST(DepthTransferTest, WeighsByTheDistanceAlongEachAxis) {
  CoarseGrid coarse = coarse_cells({corners_from(0)}, 8);
  coarse.from = {{0, 0}, {0, 1}, {0, 13}};
  const DepthTransfer transfer = make_transfer(coarse);
  EXPECT_THAT(transfer.prolongation,
              ElementsAre(FieldsAre(0, 0), FieldsAre(0, 1), FieldsAre(0, 13)));
  EXPECT_THAT(transfer.restriction_start, ElementsAre(0, 3, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_THAT(transfer.restriction_corner, ElementsAre(0, 1, 2, 1, 2, 2, 2, 2, 2, 2, 2));
  constexpr float kEighth = 0.125f;
  EXPECT_THAT(transfer.restriction_weight,
              ElementsAre(1, 0.5f, kEighth, 0.5f, kEighth, kEighth, kEighth, kEighth, kEighth,
                          kEighth, kEighth));
  EXPECT_FALSE(transfer.is_shared(0));
}

// Cells of a place share no corner: a corner that follows from one takes nothing from the other.
TEST(DepthTransferTest, TakesEachCornerFromTheCellOfItsSheet) {
  CoarseGrid coarse = coarse_cells({corners_from(0), corners_from(8)}, 16);
  coarse.from = {{1, 0}, {0, 0}};
  const DepthTransfer transfer = make_transfer(coarse);
  EXPECT_THAT(transfer.restriction_start,
              ElementsAre(0, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2));
  EXPECT_THAT(transfer.restriction_corner, ElementsAre(1, 0));  // of coarse corners 0 and 8
}

/// Fine corner 0 has copies 0 and 2, corner 1 is copy 1. Each copy of 0 lies between corners 0 and
/// 1 of its own cell (place 1). The cells share corner 0; corner 1 of the second is 8.
DepthTransfer transfer_with_a_shared_corner() {
  CoarseGrid coarse = coarse_cells({corners_from(0), {0, 8, 9, 10, 11, 12, 13, 14}}, 15);
  coarse.from = {{0, 1}, {0, 26}, {1, 1}};
  SheetCorners sheets;
  sheets.copy_count = 3;
  sheets.shared = {0};
  sheets.start = {0, 2};
  sheets.copy = {0, 2};
  sheets.weight = {0.75f, 0.25f};
  return make_transfer(coarse, sheets, 2);
}

TEST(DepthTransferTest, ASharedCornerFollowsFromNoCell) {
  const DepthTransfer transfer = transfer_with_a_shared_corner();
  EXPECT_TRUE(transfer.is_shared(0));
  EXPECT_FALSE(transfer.is_shared(1));
  EXPECT_THAT(transfer.prolongation, ElementsAre(FieldsAre(kNone, 0), FieldsAre(0, 26)));
}

// Coarse corner 0 has 3/4 · 1/2 + 1/4 · 1/2 = 1/2, 1 has 3/4 · 1/2 = 3/8, and 8 has 1/4 · 1/2 =
// 1/8.
TEST(DepthTransferTest, ASharedCornerIsTheMeanOfItsCopiesByTheirWeights) {
  const DepthTransfer::SharedCorners shared = transfer_with_a_shared_corner().shared;
  EXPECT_THAT(shared.corner, ElementsAre(0));
  EXPECT_THAT(shared.start, ElementsAre(0, 3));
  EXPECT_THAT(shared.coarse_corner, ElementsAre(0, 1, 8));
  EXPECT_THAT(shared.weight, ElementsAre(0.5f, 0.375f, 0.125f));
}

// Coarse corner 7 gathers fine corner 1, which lies at it (place 26).
TEST(DepthTransferTest, RestrictionGathersSharedCornersWithTheSameWeights) {
  const DepthTransfer transfer = transfer_with_a_shared_corner();
  EXPECT_THAT(transfer.restriction_start,
              ElementsAre(0, 1, 2, 2, 2, 2, 2, 2, 3, 4, 4, 4, 4, 4, 4, 4));
  EXPECT_THAT(transfer.restriction_corner, ElementsAre(0, 0, 1, 0));
  EXPECT_THAT(transfer.restriction_weight, ElementsAre(0.5f, 0.375f, 1, 0.125f));
}

}  // namespace
}  // namespace burnish
