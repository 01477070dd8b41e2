#include "client/tools/colours.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

TEST(Colours, APartOfTheScaleLeadsBackToItsValue) {
  for (const double beta : {0.0, 0.3, 1.0, 1.7, 3.0})
    EXPECT_NEAR(beta_of_signed_part(signed_part_of_beta(beta)), beta, 1e-6);
  for (const double kappa : {-90.0, -0.5, 0.0, 12.0, 100.0})
    EXPECT_NEAR(kappa_of_signed_part(signed_part_of_kappa(kappa, 100), 100), kappa, 1e-4);
}

}  // namespace
}  // namespace burnish
