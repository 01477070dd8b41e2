#include "common/edit/transfer_curve.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using Points = std::vector<TransferCurve::Point>;

std::string refusal(const Result<TransferCurve>& curve) {
  EXPECT_FALSE(curve.is_ok());
  EXPECT_EQ(curve.status().code(), StatusCode::kInvalidArgument);
  return curve.status().message();
}

TEST(TransferCurveText, MayBeginWithAMinusAndComeInAnyOrder) {
  const auto curve = TransferCurve::parse(" 10:5, -20:50,+0:1e1 ");
  ASSERT_TRUE(curve.is_ok()) << curve.status().message();
  EXPECT_EQ(curve->points(), (Points{{-20, 50}, {0, 10}, {10, 5}}));
}

TEST(TransferCurveText, IsRefusedWithThePointThatIsNotOne) {
  for (const char* text :
       {"", ",", "5", "5:", ":5", "5:6:7", "a:5", "5:1,", "5 6:1", "--5:1", "+-5:1"})
    EXPECT_THAT(refusal(TransferCurve::parse(text)), HasSubstr("is not kappa:alpha")) << text;
  EXPECT_THAT(refusal(TransferCurve::parse("1:2,3:x")), HasSubstr("'3:x'"));
}

TEST(TransferCurveText, IsRefusedWhereAKappaComesTwice) {
  EXPECT_THAT(refusal(TransferCurve::parse("5:1,2:3,5:1")),
              AllOf(HasSubstr("curve point 3"), HasSubstr("kappa 5 must be above"),
                    HasSubstr("before it, 5")));
}

TEST(TransferCurveText, IsRefusedWithoutFiniteNumbers) {
  for (const char* text : {"nan:5", "1:nan", "3:4,nan:5,1:2", "inf:5", "-inf:5", "1:inf"})
    EXPECT_THAT(refusal(TransferCurve::parse(text)), HasSubstr("is outside")) << text;
  EXPECT_FALSE(TransferCurve::parse("1e999:5").is_ok());
}

TEST(TransferCurveText, ParsesBackToTheSameCurve) {
  const auto curve = TransferCurve::create({{-1.0 / 3, 0.1}, {1e-300, 2.0 / 7}, {123456.789, 3.3}});
  ASSERT_TRUE(curve.is_ok());
  const auto again = TransferCurve::parse(curve->to_string());
  ASSERT_TRUE(again.is_ok()) << curve->to_string();
  EXPECT_EQ(*again, *curve);
  EXPECT_EQ(*TransferCurve::parse(TransferCurve(50).to_string()), TransferCurve(50));
}

TEST(TransferCurve, HasOneToSixtyFourPoints) {
  Points points;
  EXPECT_THAT(refusal(TransferCurve::create(points)), HasSubstr("1 to 64 points, not 0"));
  for (size_t i = 0; i < kCurvePointsMax; ++i) points.push_back({static_cast<double>(i), 5});
  EXPECT_TRUE(TransferCurve::create(points).is_ok());
  points.push_back({1e3, 5});
  EXPECT_THAT(refusal(TransferCurve::create(points)), HasSubstr("1 to 64 points, not 65"));
}

TEST(TransferCurve, NamesThePointItsValueAndTheLimit) {
  EXPECT_THAT(refusal(TransferCurve::create({{0, 5}, {1, 0.001}})),
              AllOf(HasSubstr("curve point 2"), HasSubstr("alpha 0.001"), HasSubstr("0.01..")));
  EXPECT_THAT(refusal(TransferCurve::create({{2e9, 5}})),
              AllOf(HasSubstr("curve point 1"), HasSubstr("kappa 2e+09"), HasSubstr("1e+09")));
  EXPECT_THAT(refusal(TransferCurve::create({{1, 5}, {0, 5}})),
              AllOf(HasSubstr("kappa 0 must be above"), HasSubstr("before it, 1")));
}

TEST(TransferCurve, HasAContrastOfAThousandAtMost) {
  const auto most = TransferCurve::create({{0, 0.1}, {1, 100}});
  ASSERT_TRUE(most.is_ok());
  EXPECT_DOUBLE_EQ(most->contrast(), 1000);
  EXPECT_THAT(refusal(TransferCurve::create({{0, 1}, {1, 1001}, {2, 5}})),
              AllOf(HasSubstr("1001"), HasSubstr("1000")));
}

TEST(TransferCurve, IsLinearInTheLogarithmBetweenItsPoints) {
  const TransferCurve curve = *TransferCurve::create({{-10, 1}, {10, 100}, {30, 25}});
  EXPECT_NEAR(curve.alpha(0), 10, 1e-12);
  EXPECT_NEAR(curve.alpha(-5), std::pow(100, 0.25), 1e-12);
  EXPECT_NEAR(curve.alpha(20), 50, 1e-12);
  for (const auto& point : curve.points())
    EXPECT_NEAR(curve.alpha(point.kappa), point.alpha, 1e-12);
}

TEST(TransferCurve, IsConstantBeyondItsEnds) {
  const TransferCurve curve = *TransferCurve::create({{-10, 1}, {10, 100}});
  EXPECT_EQ(curve.alpha(-10.001), 1);
  EXPECT_EQ(curve.alpha(-1e30), 1);
  EXPECT_EQ(curve.alpha(10), 100);
  EXPECT_EQ(curve.alpha(std::numeric_limits<double>::infinity()), 100);
}

TEST(TransferCurve, OfOnePointIsThatAlphaEverywhere) {
  EXPECT_TRUE(TransferCurve(7.5).is_constant());
  for (double kappa : {-1e9, 0.0, 3.0, 1e9}) EXPECT_EQ(TransferCurve(7.5).alpha(kappa), 7.5);
}

TEST(AlphaAndBeta, AreCheckedAgainstTheirLimits) {
  EXPECT_TRUE(check_alpha(kAlphaMin).is_ok() && check_alpha(kAlphaMax).is_ok());
  EXPECT_TRUE(check_beta(kBetaMin).is_ok() && check_beta(kBetaMax).is_ok());
  EXPECT_THAT(check_alpha(0).message(), HasSubstr("alpha 0 is outside 0.01.."));
  EXPECT_THAT(check_beta(-0.5).message(), HasSubstr("beta -0.5 is outside 0..10"));
  EXPECT_FALSE(check_alpha(NAN).is_ok());
  EXPECT_FALSE(check_beta(NAN).is_ok());
}

}  // namespace
}  // namespace burnish
