#include "client/model/view/position_text.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(PositionText, HasTheDecimalsThatTheScanHas) {
  EXPECT_EQ(position_text({1.23456789, -2, 0}, 4.2), "1.23457 -2.00000 0.00000");
  EXPECT_EQ(position_text({512345.678912, 1, 2}, 17000), "512345.7 1.0 2.0");
  EXPECT_EQ(position_text({0.0012345678, 0, 0}, 0.02), "0.0012346 0.0000000 0.0000000");
}

}  // namespace
}  // namespace burnish
