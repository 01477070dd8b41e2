#include "client/tools/curve_editor.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

using Eigen::Vector2d;

TEST(CurveEditor, PlacesAndPointsAreInverse) {
  const CurveEditor editor(74);
  for (const Vector2d& place : {Vector2d(0, 0), Vector2d(0.3, 0.8), Vector2d(1, 1)})
    EXPECT_LT((editor.place_of(editor.point_at(place)) - place).norm(), 1e-12);
}

TEST(CurveEditor, TheMiddleIsFlatAndTheEndsAreTheHistograms) {
  const CurveEditor editor(74);
  EXPECT_EQ(editor.point_at({0.5, 0}).kappa, 0);
  EXPECT_NEAR(editor.point_at({1, 0}).kappa, 74, 1e-9);
}

TEST(CurveEditor, NoPlotIsWiderThanACurveMayBe) {
  CurveEditor editor(1e30);
  ASSERT_TRUE(editor.add({1, 0.5}));
  ASSERT_TRUE(editor.add({0, 0.5}));
  EXPECT_EQ(editor.curve().points().size(), 3u);
}

TEST(CurveEditor, APointIsAddedWhereThePlotWasPressed) {
  CurveEditor editor(74);
  ASSERT_TRUE(editor.add({0.8, 0.9}));
  ASSERT_EQ(editor.points().size(), 2u);
  EXPECT_LT((editor.place_of(editor.points()[1]) - Vector2d(0.8, 0.9)).norm(), 1e-9);
  EXPECT_EQ(editor.dragged(), 1u);
  EXPECT_FALSE(editor.curve().is_constant());
}

TEST(CurveEditor, ADraggedPointStopsAtItsNeighbours) {
  CurveEditor editor(74);
  ASSERT_TRUE(editor.add({0.8, 0.5}));
  editor.drag_to({-3, 7});
  EXPECT_GT(editor.points()[1].kappa, editor.points()[0].kappa);
  EXPECT_LE(editor.points()[1].alpha, kFidelityMax * 1.0001);
  EXPECT_EQ(editor.curve().points().size(), 2u);
}

TEST(CurveEditor, DraggingNeverLeavesTheLimitsOfContrast) {
  CurveEditor editor(74, *TransferCurve::create({{-1, 0.02}, {1, 1}}));
  editor.begin_drag(1);
  editor.drag_to({0.9, 1});
  EXPECT_LE(editor.curve().contrast(), kCurveContrastMax);
  EXPECT_GT(editor.curve().contrast(), 0.99 * kCurveContrastMax);
}

TEST(CurveEditor, TheNearestPointWithinReachIsFound) {
  const CurveEditor editor(74, *TransferCurve::create({{-10, 5}, {10, 100}}));
  const Vector2d second = editor.place_of({10, 100});
  EXPECT_EQ(editor.point_near(second + Vector2d(0.01, 0), {0.05, 0.05}), 1u);
  EXPECT_FALSE(editor.point_near(second + Vector2d(0.1, 0), {0.05, 0.05}).has_value());
}

TEST(CurveEditor, TheLastPointStaysAndSixtyFourAreEnough) {
  CurveEditor editor(74);
  EXPECT_FALSE(editor.remove(0));
  int added = 0;
  for (int i = 0; i < 100; ++i) added += editor.add({0.01 + 0.0098 * i, 0.5});
  EXPECT_EQ(editor.points().size(), kCurvePointsMax);
  EXPECT_EQ(editor.curve().points().size(), kCurvePointsMax);
}

TEST(CurveEditor, FidelityMovesTheWholeCurveAndKeepsItsShape) {
  CurveEditor editor(74, *TransferCurve::create({{-1, 10}, {1, 1000}}));
  EXPECT_NEAR(editor.fidelity(), 100, 1e-9);
  editor.set_fidelity(50);
  EXPECT_NEAR(editor.points()[0].alpha, 5, 1e-9);
  EXPECT_NEAR(editor.points()[1].alpha, 500, 1e-9);
  editor.set_fidelity(1e9);
  EXPECT_NEAR(editor.curve().contrast(), 100, 1e-6);
}

}  // namespace
}  // namespace burnish
