#include "server/solver/tuning/slow_spots.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/reference/awkward_meshes.h"
#include "tests/server/solver/test_system.h"

namespace burnish {
namespace {

// The slow spots of a scan whose cycle has no patches.
class SlowSpots : public testing::Test {
 protected:
  SlowSpots() : system_(reference::spiked_sphere(), 6) {
    auto without_patches = std::make_shared<CyclePlan>(*system_.plan);
    without_patches->patches = {};
    spots_ = find_slow_spots({system_.prepared, system_.hierarchy, without_patches}).value();
  }

  const SparseGrid& grid() { return system_.hierarchy->depths.back().grid; }

  TestSystem system_;
  std::vector<std::vector<int32_t>> spots_;
};

TEST_F(SlowSpots, AreSmallSetsOfCornersOfWholeCells) {
  ASSERT_GT(spots_.size(), 50);
  for (const auto& spot : spots_) {
    EXPECT_LE(spot.size(), kPatchCornersMax);
    EXPECT_TRUE(std::ranges::adjacent_find(spot, std::greater_equal<>()) == spot.end());
    const std::set<int32_t> corners(spot.begin(), spot.end());
    std::set<int32_t> of_whole_cells;
    for (const auto& cell : grid().cell_corners)
      if (std::ranges::all_of(cell, [&](int32_t corner) { return corners.contains(corner); }))
        of_whole_cells.insert(cell.begin(), cell.end());
    EXPECT_EQ(of_whole_cells, corners);
  }
}

TEST_F(SlowSpots, AreNoMoreOncePatchesAreThere) {
  EXPECT_LT(find_slow_spots(system_).value().size(), spots_.size() / 10);
}

}  // namespace
}  // namespace burnish
