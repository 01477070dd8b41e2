#include "common/edit/edit.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Status check(decltype(Edit::change) change) {
  return validate(Edit{"an id", std::move(change)});
}

TEST(Edit, ThatChangesNothingOutOfRangeIsValid) {
  Stroke stroke;
  stroke.brush.radius = 1;
  stroke.path = {{0, 0, 0}};
  EXPECT_TRUE(check(SetGradientScale{10}).is_ok());
  EXPECT_TRUE(check(SetTransferCurve{}).is_ok());
  EXPECT_TRUE(check(stroke).is_ok());
  EXPECT_TRUE(check(SetCellFields{{{{1, 2, 3}, 1, 1000, 0}}}).is_ok());
}

TEST(Edit, IsRefusedByItsOwnKindsLimits) {
  EXPECT_THAT(check(SetGradientScale{NAN}).message(), HasSubstr("beta nan"));
  EXPECT_THAT(check(Stroke{}).message(), HasSubstr("brush radius"));
}

TEST(CellFields, AreRefusedByTheirNumberInTheList) {
  const auto refusal = [](double alpha1, double alpha2, double beta) {
    return check(SetCellFields{{{{0, 0, 0}, 50, 50, 1}, {{1, 0, 0}, alpha1, alpha2, beta}}});
  };
  EXPECT_EQ(refusal(0, 1, 1).code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(refusal(0, 1, 1).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("alpha1")));
  EXPECT_THAT(refusal(1, NAN, 1).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("alpha2")));
  EXPECT_THAT(refusal(1, 1, 11).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("beta 11")));
  EXPECT_THAT(refusal(1, 1001, 1).message(), AllOf(HasSubstr("cell field 2"), HasSubstr("1000")));
}

}  // namespace
}  // namespace burnish
