#include "common/page_frames/page_corners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

constexpr int kBits = 10;
constexpr int kDepth = 4;
constexpr int kStepsPerCellSide = 1 << (kBits - kDepth);

TEST(PageCorners, APositionIsTheMiddleOfItsStep) {
  const CellPlace place = cell_place({3 * kStepsPerCellSide, 64 + 32, 63}, kBits, kDepth);
  EXPECT_EQ(place.cell, Vec3i(3, 1, 0));
  EXPECT_EQ(place.local[0], 0.5F / 64);
  EXPECT_EQ(place.local[1], 32.5F / 64);
  EXPECT_EQ(place.local[2], 63.5F / 64);
}

TEST(PageCorners, ThePlaceIsExactOnTheFinestLattice) {
  const CellPlace place = cell_place(Vec3i::Constant((1 << 24) - 1), 24, 4);
  EXPECT_EQ(place.cell, Vec3i(15, 15, 15));
  EXPECT_EQ(1 - static_cast<double>(place.local[0]), std::ldexp(0.5, -20));
}

TEST(PageCorners, NeighbouringCellsShareCorners) {
  const std::vector<Vec3i> positions = {{0, 0, 0}, {64, 0, 0}, {65, 1, 1}};
  const PageCorners corners = make_page_corners(positions, kBits, kDepth);
  EXPECT_EQ(corners.places.size(), 12u);
  EXPECT_EQ(count_page_corners(positions, kBits, kDepth), 12u);
  EXPECT_EQ(corners.of_vertex[0][1], corners.of_vertex[1][0]);
  EXPECT_EQ(corners.of_vertex[1], corners.of_vertex[2]);
}

TEST(PageCorners, AreInMortonOrder) {
  const auto& small = small_pages();
  for (const Page& page : small.pages) {
    const PageCorners corners =
        make_page_corners(page.positions, small.lattice.bits, small.grid.depth);
    EXPECT_TRUE(std::ranges::is_sorted(corners.places));
    for (size_t v = 0; v < page.positions.size(); ++v) {
      const Vec3i cell = cell_place(page.positions[v], small.lattice.bits, small.grid.depth).cell;
      EXPECT_EQ(morton_point(corners.places[corners.of_vertex[v][6]]), cell + Vec3i(0, 1, 1));
    }
  }
}

TEST(PageCorners, ALinearFieldIsEvaluatedAtThePlaceOfTheVertex) {
  const std::vector<Vec3i> positions = {{10, 70, 900}, {1023, 0, 512}};
  const PageCorners corners = make_page_corners(positions, kBits, kDepth);
  std::vector<Vec3f> field;
  for (const MortonKey place : corners.places)
    field.emplace_back(0.25F * morton_point(place).cast<float>());
  std::vector<Vec3f> displacements(positions.size());
  evaluate_page(corners, positions, kBits, kDepth, field, displacements);
  for (size_t v = 0; v < positions.size(); ++v) {
    const Vec3f expected =
        0.25F * (positions[v].cast<float>() + Vec3f::Constant(0.5F)) / kStepsPerCellSide;
    EXPECT_LT((displacements[v] - expected).norm(), 1e-6F);
  }
}

TEST(PageCorners, APageOfScatteredVerticesHasEightEach) {
  std::vector<Vec3i> positions;
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y) positions.emplace_back(128 * x, 128 * y, 128);
  EXPECT_EQ(count_page_corners(positions, kBits, kDepth), 8 * positions.size());
}

}  // namespace
}  // namespace burnish
