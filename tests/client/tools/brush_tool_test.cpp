#include "client/tools/brush_tool.h"

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
  EXPECT_EQ(painted_beta(0, BrushMode::kInvert), 2);
  EXPECT_EQ(painted_beta(2, BrushMode::kInvert), 0);
  EXPECT_EQ(painted_beta(5, BrushMode::kInvert), 0);
  EXPECT_EQ(painted_beta(0.25, BrushMode::kRestore), 1);
  EXPECT_EQ(painted_beta(0.25, BrushMode::kPaint), 0.25);
}

TEST(BrushTool, AStrokeKeepsWhatTheCursorPassed) {
  BrushTool tool = make_tool();
  tool.begin(BrushMode::kInvert, Vec3d(0, 0, 0));
  EXPECT_TRUE(tool.extend(Vec3d(1, 0, 0)));
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
  while (tool.extend(Vec3d(0.3 * ++points, 0, 0))) ASSERT_LT(points, 10'000);
  const Stroke stroke = tool.end();
  EXPECT_TRUE(validate(stroke).is_ok());
  EXPECT_GT(dab_centres(stroke).size(), kStrokeDabsMax * 9 / 10);
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
