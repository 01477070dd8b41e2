#include "server/manager/page_values.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

constexpr int kBits = 8;
constexpr int kDepth = 4;

/// Two cells beside each other, along x.
SparseGrid two_cells() {
  return make_finest_grid(kDepth,
                          std::vector<MortonKey>{morton_key({2, 2, 2}), morton_key({3, 2, 2})});
}

/// A page whose vertices lie in the middle of cells.
Page page_in(const std::vector<Vec3i>& cells) {
  Page page;
  page.id = 9;
  for (const Vec3i& cell : cells) page.positions.push_back(16 * cell + Vec3i::Constant(8));
  return page;
}

TEST(PageValuesOfCells, AVertexHasTheValueOfItsCell) {
  const Page page = page_in({{3, 2, 2}, {2, 2, 2}, {3, 2, 2}});
  const PageValues values = page_values(page, kBits, two_cells(), std::vector<float>{0.5F, 2});
  EXPECT_EQ(values.page, 9u);
  EXPECT_EQ(values.at(0), 2);
  EXPECT_EQ(values.at(1), 0.5F);
  EXPECT_EQ(values.at(2), 2);
}

TEST(PageValuesOfCells, AVertexOnAPlaneTakesTheCellThatItTouches) {
  Page page;
  page.positions = {{16 * 4, 16 * 2 + 8, 16 * 2 + 8}};  // within half a step of cell (3, 2, 2)
  EXPECT_EQ(page_values(page, kBits, two_cells(), std::vector<float>{0.5F, 2}).low, 2);
}

TEST(PageValuesOfCells, AVertexWithoutACellDoesNotCount) {
  const Page page = page_in({{9, 9, 9}, {2, 2, 2}, {3, 2, 2}});
  const PageValues values = page_values(page, kBits, two_cells(), std::vector<float>{5, 6});
  EXPECT_EQ(values.low, 5);
  EXPECT_EQ(values.at(0), 5);
}

TEST(PageValuesOfCells, WithoutAnyCellAllAreZero) {
  const PageValues values =
      page_values(page_in({{9, 9, 9}}), kBits, two_cells(), std::vector<float>{5, 6});
  EXPECT_EQ(values.at(0), 0);
}

}  // namespace
}  // namespace burnish
