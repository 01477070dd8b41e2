#include "client/pages/drawn_ranges.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

// A page of four patches, of 1, 2, 3 and 4 triangles, in slot 0.
class DrawnRanges : public testing::Test {
 protected:
  DrawnRanges() {
    Page page;
    page.patches = {{0, 1}, {1, 2}, {2, 3}, {3, 4}};
    cache_.hold(4, {});
    cache_.decode(4, std::make_shared<const Page>(page));
    cache_.place(4);
    cut_.set = {0, 0, 0, 0, 1};
    cut_.pages = cut_.visible_pages = {4};
  }

  PageCache cache_{PageBudget{}};
  ChosenCut cut_;
};

TEST_F(DrawnRanges, NeighbouringPatchesAreOneRange) {
  const std::vector<DrawnRange> expected = {{0, 0, 10, 4}};
  EXPECT_EQ(drawn_ranges(cut_, cache_), expected);
}

TEST_F(DrawnRanges, AFinerPageInTheCutLeavesAGap) {
  cut_.set[1] = 1;
  const std::vector<DrawnRange> expected = {{0, 0, 1, 4}, {0, 3, 7, 4}};
  EXPECT_EQ(drawn_ranges(cut_, cache_), expected);
}

TEST_F(DrawnRanges, APageThatIsReplacedWhollyDrawsNothing) {
  cut_.set = {1, 1, 1, 1, 1};
  EXPECT_TRUE(drawn_ranges(cut_, cache_).empty());
}

TEST_F(DrawnRanges, APageOutOfViewDrawsNothing) {
  cut_.visible_pages.clear();
  EXPECT_TRUE(drawn_ranges(cut_, cache_).empty());
}

}  // namespace
}  // namespace burnish
