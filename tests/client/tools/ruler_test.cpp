#include "client/tools/ruler.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Ruler, MeasuresBothSurfacesBetweenTwoPoints) {
  Ruler ruler;
  ruler.put({{0, 0, 0}, {0, 0, 1}});
  EXPECT_FALSE(ruler.length());
  ruler.put({{3, 4, 0}, {3, 0, 1}});
  EXPECT_DOUBLE_EQ(ruler.length().value(), 5);
  EXPECT_DOUBLE_EQ(ruler.original_length().value(), 3);
}

TEST(Ruler, BeginsAnewWithTheThirdPoint) {
  Ruler ruler;
  for (const double x : {1.0, 2.0, 3.0}) ruler.put({{x, 0, 0}, {x, 0, 0}});
  ASSERT_EQ(ruler.ends().size(), 1u);
  EXPECT_EQ(ruler.ends()[0].edited.x(), 3);
}

}  // namespace
}  // namespace burnish
