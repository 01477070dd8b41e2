#include "common/grid/morton.h"

#include <random>

#include <gtest/gtest.h>

#include "common/grid/sparse_grid.h"

namespace burnish {
namespace {

// Interleaves bit by bit, by the definition.
MortonKey interleaved(const Vec3i& p) {
  MortonKey key = 0;
  for (int bit = 0; bit < 21; ++bit)
    for (int axis = 0; axis < 3; ++axis)
      key |= static_cast<MortonKey>(p[axis] >> bit & 1) << (3 * bit + axis);
  return key;
}

TEST(MortonKey, InterleavesTheBitsWithILowest) {
  EXPECT_EQ(morton_key({1, 0, 0}), 1u);
  EXPECT_EQ(morton_key({0, 1, 0}), 2u);
  EXPECT_EQ(morton_key({0, 0, 1}), 4u);
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3i p(random() & 0x1fffff, random() & 0x1fffff, random() & 0x1fffff);
    EXPECT_EQ(morton_key(p), interleaved(p));
    EXPECT_EQ(morton_point(morton_key(p)), p);
  }
}

TEST(MortonKey, HoldsTheOutermostCornersOfTheDeepestGrid) {
  for (const Vec3i& p : {Vec3i(4096, 4096, 4096), Vec3i(0, 0, 4096), Vec3i(0x1fffff, 0, 0x1fffff)})
    EXPECT_EQ(morton_point(morton_key(p)), p);
}

TEST(MortonKey, OfAChildIsItsParentsAndThreeBitsInCornerOrder) {
  const Vec3i parent(13, 200, 77);
  for (int a = 0; a < kCornersPerCell; ++a) {
    const MortonKey child = morton_key(2 * parent + corner_offset(a));
    EXPECT_EQ(child >> 3, morton_key(parent));
    EXPECT_EQ(child & 7, static_cast<MortonKey>(a));
  }
}

}  // namespace
}  // namespace burnish
