#include "client/sheets/sheet_choice.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(SheetChoice, TakesTheCoarsestSheetThatIsFineEnough) {
  const SheetEntry entries[] = {{100, 64, 32}, {50, 32, 16}, {20, 16, 9}};
  const SheetFacts facts{{40, 8.0f}, entries};
  EXPECT_EQ(coarsest_enough(facts, 9), 0);
  EXPECT_EQ(coarsest_enough(facts, 8), 0);
  EXPECT_EQ(coarsest_enough(facts, 4.1f), 0);
  EXPECT_EQ(coarsest_enough(facts, 4), 1);
  EXPECT_EQ(coarsest_enough(facts, 2), 2);
  EXPECT_EQ(coarsest_enough(facts, 0.1f), 2);
}

TEST(SheetChoice, DensityFallsWithTheDistanceToThePagesNearestPoint) {
  PageView view;
  view.eye = Vec3f(0, 0, 10);
  view.pixels_at_one = 600;
  view.nearest = 0.1f;
  const PageBounds bounds{.centre = Vec3f::Zero(), .radius = 4};
  EXPECT_FLOAT_EQ(needed_density(view, bounds, 0, 1), 100);
  EXPECT_FLOAT_EQ(needed_density(view, bounds, 1, 1), 120);
  EXPECT_FLOAT_EQ(needed_density(view, bounds, 0, kTexelsPerPixelMoving), 80);
}

}  // namespace
}  // namespace burnish
