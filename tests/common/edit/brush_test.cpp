#include "common/edit/brush.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr FallOff kFallOffs[] = {FallOff::kSmooth, FallOff::kLinear, FallOff::kSharp,
                                 FallOff::kConstant};

Stroke stroke_along(std::vector<Vec3d> path, double radius) {
  Stroke stroke;
  stroke.brush.radius = radius;
  stroke.path = std::move(path);
  return stroke;
}

// Returns the same polyline with `parts` samples per segment, unevenly spread and some doubled.
Stroke resampled(const Stroke& stroke, int parts) {
  Stroke finer = stroke;
  finer.path = {stroke.path.front()};
  for (size_t i = 1; i < stroke.path.size(); ++i) {
    for (int part = 1; part <= parts; ++part) {
      const double t = std::pow(static_cast<double>(part) / parts, 1.7);
      finer.path.push_back((1 - t) * stroke.path[i - 1] + t * stroke.path[i]);
      if (part % 3 == 0) finer.path.push_back(finer.path.back());
    }
  }
  return finer;
}

void expect_same_centres(const Stroke& a, const Stroke& b, double scale) {
  const auto centres_a = dab_centres(a), centres_b = dab_centres(b);
  ASSERT_EQ(centres_a.size(), centres_b.size());
  for (size_t i = 0; i < centres_a.size(); ++i)
    ASSERT_LT((centres_a[i] - centres_b[i]).norm(), 1e-12 * scale) << "dab " << i;
}

TEST(FallOff, IsOneAtTheCentreAndNothingFromTheRadiusOn) {
  for (FallOff fall_off : kFallOffs) {
    EXPECT_EQ(fall_off_weight(fall_off, 0), 1);
    EXPECT_EQ(fall_off_weight(fall_off, 1), 0);
    EXPECT_EQ(fall_off_weight(fall_off, 5), 0);
    EXPECT_EQ(fall_off_weight(fall_off, NAN), 0);
  }
}

TEST(FallOff, NeverRises) {
  for (FallOff fall_off : kFallOffs)
    for (int i = 0; i < 1000; ++i)
      ASSERT_GE(fall_off_weight(fall_off, i / 1000.0), fall_off_weight(fall_off, (i + 1) / 1000.0));
}

TEST(FallOff, HasItsOwnHeightHalfWay) {
  EXPECT_EQ(fall_off_weight(FallOff::kSmooth, 0.5), 0.5);
  EXPECT_EQ(fall_off_weight(FallOff::kLinear, 0.5), 0.5);
  EXPECT_EQ(fall_off_weight(FallOff::kSharp, 0.5), 0.25);
  EXPECT_EQ(fall_off_weight(FallOff::kConstant, 0.5), 1);
}

TEST(FallOff, SmoothBeginsAndEndsLevel) {
  EXPECT_NEAR(fall_off_weight(FallOff::kSmooth, 1e-4), 1, 1e-7);
  EXPECT_NEAR(fall_off_weight(FallOff::kSmooth, 1 - 1e-4), 0, 1e-7);
}

TEST(Dabs, AreAQuarterRadiusApartFromTheFirstPointOn) {
  const auto centres = dab_centres(stroke_along({{1, 2, 3}, {2.1, 2, 3}}, 1));
  ASSERT_EQ(centres.size(), 5u);
  for (size_t i = 0; i < centres.size(); ++i)
    EXPECT_LT((centres[i] - Vec3d(1 + 0.25 * i, 2, 3)).norm(), 1e-15);
}

TEST(Dabs, OfASinglePointAreOne) {
  EXPECT_EQ(dab_centres(stroke_along({{1, 2, 3}}, 0.1)).size(), 1u);
  EXPECT_EQ(dab_centres(stroke_along({{1, 2, 3}, {1, 2, 3}}, 0.1)).size(), 1u);
}

TEST(Dabs, DoNotDependOnHowThePathWasSampled) {
  const Stroke stroke =
      stroke_along({{0, 0, 0}, {3, 1, 0.5}, {2, 4, -1}, {2, 4.3, -1}, {-5, 0.1, 7}}, 0.37);
  for (int parts : {2, 7, 100, 800}) expect_same_centres(stroke, resampled(stroke, parts), 20);
}

TEST(Dabs, AtTheVeryEndOfThePathDoNotDependOnItsSampling) {
  for (int dabs : {3, 10, 37, 100}) {
    const Vec3d end = Vec3d(1, 2, -2) / 3 * 0.025 * dabs;  // a whole number of spacings away
    const Stroke stroke = stroke_along({Vec3d::Zero(), end}, 0.1);
    for (int parts : {2, 7, 100, 800}) expect_same_centres(stroke, resampled(stroke, parts), 1);
  }
}

TEST(StrokeLimits, AreFourThousandAndNinetySixDabs) {
  const double longest = 0.25 * kStrokeDabsMax;  // one dab too many
  EXPECT_TRUE(validate(stroke_along({{0, 0, 0}, {longest - 0.1, 0, 0}}, 1)).is_ok());
  EXPECT_THAT(validate(stroke_along({{0, 0, 0}, {longest + 0.1, 0, 0}}, 1)).message(),
              HasSubstr("more than 4096 dabs"));
  EXPECT_THAT(validate(stroke_along({{0, 0, 0}, {1e18, 0, 0}}, 1e-18)).message(),
              HasSubstr("more than 4096 dabs"));
}

TEST(StrokeLimits, AreNamedWithTheValue) {
  const Stroke good = stroke_along({{0, 0, 0}}, 1);
  EXPECT_TRUE(validate(good).is_ok());
  const auto refusal = [&](auto&& change) {
    Stroke stroke = good;
    change(stroke);
    EXPECT_EQ(validate(stroke).code(), StatusCode::kInvalidArgument);
    return validate(stroke).message();
  };
  EXPECT_THAT(refusal([](Stroke& s) { s.brush.radius = 0; }), HasSubstr("radius 0"));
  EXPECT_THAT(refusal([](Stroke& s) { s.brush.radius = NAN; }), HasSubstr("radius nan"));
  EXPECT_THAT(refusal([](Stroke& s) { s.brush.strength = 0; }), HasSubstr("strength 0"));
  EXPECT_THAT(refusal([](Stroke& s) { s.brush.strength = 1.5; }),
              AllOf(HasSubstr("strength 1.5"), HasSubstr("(0, 1]")));
  EXPECT_THAT(refusal([](Stroke& s) { s.brush.beta = 11; }), HasSubstr("beta 11"));
  EXPECT_THAT(refusal([](Stroke& s) { s.path.clear(); }), HasSubstr("no points"));
  EXPECT_THAT(refusal([](Stroke& s) { s.path.push_back({0, NAN, 0}); }), HasSubstr("point 2"));
  EXPECT_THAT(refusal([](Stroke& s) { s.path[0].x() = 2e18; }), HasSubstr("point 1"));
  EXPECT_THAT(refusal([](Stroke& s) { s.path.resize(kStrokeDabsMax + 1, Vec3d::Zero()); }),
              AllOf(HasSubstr("4097 points"), HasSubstr("4096")));
}

}  // namespace
}  // namespace burnish
