#include "common/service/page_values.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(PageValues, AreWithinHalfAStep) {
  const std::vector<float> values = {-2, 0.3F, 7, 1.25F};
  const PageValues packed = pack_page_values(3, values);
  EXPECT_EQ(packed.page, 3u);
  EXPECT_EQ(packed.low, -2);
  EXPECT_EQ(packed.high, 7);
  for (size_t v = 0; v < values.size(); ++v) EXPECT_NEAR(packed.at(v), values[v], 4.51 / 255);
  EXPECT_EQ(packed.at(0), -2);
  EXPECT_EQ(packed.at(2), 7);
}

TEST(PageValues, EqualValuesNeedNoSteps) {
  const PageValues packed = pack_page_values(3, std::vector<float>(5, 0.7F));
  EXPECT_TRUE(packed.steps.empty());
  EXPECT_EQ(packed.at(4), 0.7F);
}

}  // namespace
}  // namespace burnish
