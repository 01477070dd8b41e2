#include "client/tools/brush_tool.h"

#include <functional>

#include <gtest/gtest.h>

#include "common/base/limits.h"

namespace burnish {
namespace {

BrushTool make_tool() {
  BrushTool tool;
  tool.brush = {.radius = 1, .strength = 0.5, .beta = 0};
  return tool;
}

TEST(BrushTool, ControlMirrorsBetaAboutOneAndShiftRestores) {
  Brush brush;
  const auto painted = [&](double beta, BrushMode mode) {
    brush.beta = beta;
    return painted_value(brush, mode);
  };
  EXPECT_EQ(painted(0, BrushMode::kInvert), 2);
  EXPECT_EQ(painted(2, BrushMode::kInvert), 0);
  EXPECT_EQ(painted(5, BrushMode::kInvert), 0);
  EXPECT_EQ(painted(0.25, BrushMode::kRestore), 1);
  EXPECT_EQ(painted(0.25, BrushMode::kPaint), 0.25);
  brush.edges = true;
  EXPECT_EQ(painted(0.75, BrushMode::kInvert), 0.25);
  EXPECT_EQ(painted(0.75, BrushMode::kRestore), 0);
  brush.edges = false;
  brush.texture = true;
  EXPECT_EQ(painted(2, BrushMode::kInvert), 0);
  EXPECT_EQ(painted(0, BrushMode::kInvert), 2);
  EXPECT_EQ(painted(4, BrushMode::kRestore), 1);
}

TEST(BrushTool, AStrokeKeepsWhatTheCursorPassed) {
  BrushTool tool = make_tool();
  tool.begin(BrushMode::kInvert, Vec3d(0, 0, 0));
  EXPECT_FALSE(tool.extend(Vec3d(1, 0, 0)).has_value());
  const Stroke stroke = tool.end();
  EXPECT_FALSE(tool.is_drawing());
  EXPECT_EQ(stroke.path.size(), 2u);
  EXPECT_EQ(stroke.brush.beta, 2);
  EXPECT_TRUE(validate(stroke).is_ok());
}

TEST(BrushTool, PointsNearerThanDabsCanTellApartAreLeftOut) {
  BrushTool tool = make_tool();
  tool.begin(BrushMode::kPaint, Vec3d(0, 0, 0));
  for (int i = 0; i < 100; ++i) tool.extend(Vec3d(0.001 * i, 0, 0));
  EXPECT_EQ(tool.stroke().path.size(), 1u);
}

TEST(BrushTool, NewPointsAreGivenOnce) {
  BrushTool tool = make_tool();
  tool.begin(BrushMode::kPaint, Vec3d(0, 0, 0));
  EXPECT_EQ(tool.take_new_points().size(), 1u);
  EXPECT_EQ(tool.take_new_points().size(), 0u);
  tool.extend(Vec3d(1, 0, 0));
  tool.extend(Vec3d(2, 0, 0));
  EXPECT_EQ(tool.take_new_points().size(), 2u);
}

TEST(BrushTool, AFullStrokeIsStillValid) {
  BrushTool tool = make_tool();
  tool.begin(BrushMode::kPaint, Vec3d(0, 0, 0));
  int points = 0;
  while (!tool.extend(Vec3d(0.3 * ++points, 0, 0))) ASSERT_LT(points, 10'000);
  const Stroke stroke = tool.end();
  EXPECT_TRUE(validate(stroke).is_ok());
  EXPECT_GT(dab_centres(stroke).size(), kStrokeDabsMax * 9 / 10);
}

// Draws along x in `steps`, with the pressure that a function of x gives.
std::vector<Stroke> drawn(double step, const std::function<double(double)>& pressure) {
  BrushTool tool = make_tool();
  std::vector<Stroke> strokes;
  tool.begin(BrushMode::kPaint, Vec3d(0, 0, 0), pressure(0));
  for (double x = step; x <= 10; x += step) {
    while (const auto start = tool.extend(Vec3d(x, 0, 0), pressure(x))) {
      strokes.push_back(tool.end());
      tool.go_on(*start, pressure(x));
    }
  }
  strokes.push_back(tool.end());
  return strokes;
}

TEST(BrushTool, APressureThatStaysIsOneStrokeOfThatPartOfTheStrength) {
  const std::vector<Stroke> strokes = drawn(0.15, [](double) { return 0.4; });
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_DOUBLE_EQ(strokes[0].brush.strength, 0.2);
}

TEST(BrushTool, ARisingPressureIsStrokesOfRisingStrength) {
  const std::vector<Stroke> strokes = drawn(0.15, [](double x) { return x / 10; });
  ASSERT_GT(strokes.size(), 5u);
  ASSERT_LT(strokes.size(), 12u);
  for (size_t i = 1; i < strokes.size(); ++i) {
    EXPECT_GT(strokes[i].brush.strength, strokes[i - 1].brush.strength);
    EXPECT_TRUE(validate(strokes[i]).is_ok());
  }
}

TEST(BrushTool, TheStrokesOfAGestureHaveTheDabsOfOne) {
  for (const double step : {0.15, 0.7}) {  // nearer and farther than dabs
    std::vector<double> dabs;
    for (const Stroke& stroke : drawn(step, [](double x) { return x / 10; }))
      for (const Vec3d& dab : dab_centres(stroke)) dabs.push_back(dab.x());
    const std::vector<Stroke> whole = drawn(step, [](double) { return 1; });
    ASSERT_EQ(dabs.size(), dab_centres(whole[0]).size());
    for (size_t i = 0; i < dabs.size(); ++i) EXPECT_NEAR(dabs[i], 0.25 * double(i), 1e-9);
  }
}

TEST(BrushTool, TheRadiusStaysWithinTheScan) {
  BrushTool tool = make_tool();
  tool.scale_radius(1e9, 10);
  EXPECT_DOUBLE_EQ(tool.brush.radius, 5);
  tool.scale_radius(1e-9, 10);
  EXPECT_DOUBLE_EQ(tool.brush.radius, 1e-3);
}

}  // namespace
}  // namespace burnish
