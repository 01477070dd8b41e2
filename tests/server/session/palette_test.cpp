#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/mesh/statistics/statistics.h"
#include "tests/server/session/solved_session.h"

namespace burnish {
namespace {

using testing::HasSubstr;

const TransferCurve kEdges = TransferCurve::parse("-20:10,0:80,20:40").value();
const Palette kTwo{{{"letters", 0xd04040, kEdges}, {"ground", 0x4060d0, TransferCurve(20)}}};

/// A brush over the whole sphere of radius 1.
Stroke painted_everywhere(int curve) {
  Stroke stroke{{10, 1, 0, FallOff::kConstant}, {Vec3d(0, 0, 1)}};
  stroke.brush.curve = curve;
  return stroke;
}

CellAlphas alphas(const Session& session) {
  return session.fields().alphas();
}

TEST(PaletteOfCurves, ACurvePaintedEverywhereIsAsIfItWereSet) {
  const TriangleMesh blob = lumpy_scan();
  const auto painted = session_over(blob), set = session_over(blob);
  const auto by_paint =
      exact_surface(*painted, {SetPalette{kTwo}, painted_everywhere(1), SetGradientScale{0}});
  const auto by_curve = exact_surface(*set, {SetTransferCurve{kEdges}, SetGradientScale{0}});
  EXPECT_EQ(alphas(*painted), alphas(*set));
  EXPECT_LT(farthest(by_paint, by_curve), 1e-6 * compute_statistics(blob).diagonal());
}

TEST(PaletteOfCurves, UnpaintedItChangesNothing) {
  const auto session = session_over(lumpy_scan()), plain = session_over(lumpy_scan());
  ASSERT_TRUE(session->apply({"1", SetPalette{kTwo}}).is_ok());
  EXPECT_EQ(alphas(*session), alphas(*plain));
  EXPECT_TRUE(session->fields().view().metric.is_uniform());
}

TEST(PaletteOfCurves, AtABorderTheMeanOfLogAlphaRules) {
  const auto session = session_over(make_icosphere(4, 1));
  Stroke half = painted_everywhere(2);
  half.brush.strength = 0.5;
  ASSERT_TRUE(session->apply({"1", SetPalette{kTwo}}).is_ok());
  ASSERT_TRUE(session->apply({"2", half}).is_ok());
  const CellAlphas found = alphas(*session);
  for (const float alpha : found.alpha1) ASSERT_NEAR(alpha, std::sqrt(50.0 * 20.0), 1e-3);
}

TEST(PaletteOfCurves, ALaterCurveCoversAnEarlierOne) {
  const auto session = session_over(make_icosphere(4, 1));
  ASSERT_TRUE(session->apply({"1", SetPalette{kTwo}}).is_ok());
  ASSERT_TRUE(session->apply({"2", painted_everywhere(1)}).is_ok());
  ASSERT_TRUE(session->apply({"3", painted_everywhere(2)}).is_ok());
  const CellAlphas covered = alphas(*session);
  for (const float alpha : covered.alpha2) ASSERT_EQ(alpha, 20);
  ASSERT_TRUE(session->apply({"4", Undo{}}).is_ok());
  const auto set = session_over(make_icosphere(4, 1));
  ASSERT_TRUE(set->apply({"1", SetTransferCurve{kEdges}}).is_ok());
  EXPECT_EQ(alphas(*session), alphas(*set));
}

TEST(PaletteOfCurves, AChangedCurveChangesTheCellsThatItRules) {
  const auto session = session_over(make_icosphere(4, 1));
  ASSERT_TRUE(session->apply({"1", SetPalette{kTwo}}).is_ok());
  Stroke spot{{0.5, 1, 0, FallOff::kConstant}, {Vec3d(0, 0, 1)}};
  spot.brush.curve = 2;
  ASSERT_TRUE(session->apply({"2", spot}).is_ok());
  Palette changed = kTwo;
  changed.curves[1].curve = TransferCurve(33);
  ASSERT_TRUE(session->apply({"3", SetPalette{changed}}).is_ok());
  const CellAlphas found = alphas(*session);
  EXPECT_THAT(found.alpha1, testing::Contains(33.0f));
  EXPECT_THAT(found.alpha1, testing::Each(testing::AnyOf(33.0f, 50.0f)));
}

TEST(PaletteOfCurves, RefusesABrushOfACurveThatItLacks) {
  const auto session = session_over(make_icosphere(3, 1));
  const Status status = session->edited().layers().take({"1", painted_everywhere(3)});
  EXPECT_EQ(status.code(), StatusCode::kFailedPrecondition);
  EXPECT_THAT(status.message(), HasSubstr("curve 3"));
}

TEST(PaletteOfCurves, RefusesCurvesThatDifferTooMuchFromTheSessions) {
  const auto session = session_over(make_icosphere(3, 1));
  const Palette far{{{"far", 0, TransferCurve(1e5)}}};
  const Status status = session->edited().layers().take({"1", SetPalette{far}});
  EXPECT_EQ(status.code(), StatusCode::kInvalidArgument);
  EXPECT_THAT(status.message(), HasSubstr("100000"));
}

}  // namespace
}  // namespace burnish
