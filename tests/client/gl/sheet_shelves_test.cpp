#include "client/gl/sheet_shelves.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

struct Taken {
  ShelfPlace place;
  int width;
  int height;
};

bool overlap(const Taken& one, const Taken& other) {
  return one.place.layer == other.place.layer && one.place.x < other.place.x + other.width &&
         other.place.x < one.place.x + one.width && one.place.y < other.place.y + other.height &&
         other.place.y < one.place.y + one.height;
}

TEST(SheetShelves, NoTwoRectanglesOverlapAndAllLieInside) {
  SheetShelves shelves(256, 2);
  std::vector<Taken> taken;
  for (int i = 0; i < 200; ++i) {
    const int width = 9 + i * 37 % 90, height = 9 + i * 53 % 70;
    const auto place = shelves.take(width, height);
    if (!place) continue;
    EXPECT_EQ(place->x % SheetShelves::kShelfStep, 0);
    EXPECT_EQ(place->y % SheetShelves::kShelfStep, 0);
    EXPECT_LE(place->x + width, 256);
    EXPECT_LE(place->y + height, 256);
    for (const Taken& other : taken) EXPECT_FALSE(overlap({*place, width, height}, other));
    taken.push_back({*place, width, height});
  }
  EXPECT_GT(taken.size(), 30u);
}

TEST(SheetShelves, AnEmptyShelfServesAgain) {
  SheetShelves shelves(64, 1);
  const auto first = shelves.take(64, 64);
  ASSERT_TRUE(first);
  EXPECT_FALSE(shelves.take(9, 9));
  shelves.give_back(*first);
  EXPECT_TRUE(shelves.take(64, 40));
}

TEST(SheetShelves, ASideAsLargeAsALayerFits) {
  SheetShelves shelves(1024, 1);
  EXPECT_TRUE(shelves.take(1024, 1023));
}

}  // namespace
}  // namespace burnish
