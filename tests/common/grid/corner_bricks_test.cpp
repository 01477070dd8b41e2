#include "common/grid/corner_bricks.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace burnish {
namespace {

// Returns cells of three components that share bricks and places.
std::vector<GridKey> scattered_cells() {
  std::minstd_rand random(7);
  std::set<GridKey> cells;
  for (int i = 0; i < 400; ++i) {
    const auto next = [&] { return static_cast<int>(random() % 12); };
    const Vec3i place(next(), next(), next());
    cells.insert({morton_key(place), static_cast<int32_t>(random() % 3)});
  }
  return {cells.begin(), cells.end()};
}

GridKey corner_of(const GridKey& cell, int a) {
  return {morton_key(morton_point(cell.place) + corner_offset(a)), cell.component};
}

TEST(CornerBricks, ListTheCornersOfAllCellsOnceAndInOrder) {
  const std::vector<GridKey> cells = scattered_cells();
  std::set<GridKey> expected;
  for (const GridKey& cell : cells)
    for (int a = 0; a < kCornersPerCell; ++a) expected.insert(corner_of(cell, a));
  const std::vector<GridKey> corners = CornerBricks(cells).corners();
  EXPECT_EQ(corners, std::vector<GridKey>(expected.begin(), expected.end()));
}

// Numbers the cells' corners and looks each up in the list.
void expect_numbered(const std::vector<GridKey>& cells) {
  const CornerBricks bricks(cells);
  const std::vector<GridKey> corners = bricks.corners();
  std::vector<std::array<int32_t, kCornersPerCell>> found(cells.size());
  for (const CornerBricks::Run& run : bricks.runs()) bricks.number(run, cells.data(), found.data());
  for (size_t c = 0; c < cells.size(); ++c)
    for (int a = 0; a < kCornersPerCell; ++a)
      ASSERT_EQ(corners.at(found[c][a]), corner_of(cells[c], a))
          << "cell " << c << ", corner " << a;
}

TEST(CornerBricks, NumberTheCornersOfEveryCell) {
  expect_numbered(scattered_cells());
}

// Dust: an algorithm that compares all components of a place with each other would not end.
TEST(CornerBricks, NumberTheCornersOfManyComponentsInOnePlace) {
  std::vector<GridKey> cells;
  for (int32_t component = 0; component < 200'000; ++component) cells.push_back({7, component});
  expect_numbered(cells);
}

}  // namespace
}  // namespace burnish
