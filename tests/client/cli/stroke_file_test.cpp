#include "client/cli/stroke_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace burnish {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  const auto strokes = parse_strokes(text, "s.txt");
  return strokes.is_ok() ? "accepted" : strokes.status().message();
}

TEST(StrokeFile, SeveralStrokesWithCommentsAreRead) {
  const auto strokes = parse_strokes(
      "# two strokes\nbrush 0.5 1 2 sharp\n1 2 3\n-4 5e-1 6 # a point\n\nbrush 1 0.5 0 smooth\n"
      "0 0 0\n",
      "s.txt");
  ASSERT_TRUE(strokes.is_ok()) << strokes.status().message();
  ASSERT_EQ(strokes.value().size(), 2u);
  EXPECT_EQ(strokes.value()[0].brush.fall_off, FallOff::kSharp);
  EXPECT_EQ(strokes.value()[0].path[1], Vec3d(-4, 0.5, 6));
  EXPECT_EQ(strokes.value()[1].brush.strength, 0.5);
}

TEST(StrokeFile, AStrokeIsConnectedUnlessItsBrushGoesThrough) {
  const auto strokes = parse_strokes(
      "brush 1 1 2 sharp\n1 2 3\nbrush 1 1 2 sharp through\n1 2 3\n"
      "brush 1 1 2 sharp band:2 through\n1 2 3\n",
      "s.txt");
  ASSERT_TRUE(strokes.is_ok()) << strokes.status().message();
  EXPECT_TRUE(strokes.value()[0].brush.connected);
  EXPECT_FALSE(strokes.value()[1].brush.connected);
  EXPECT_FALSE(strokes.value()[2].brush.connected);
  EXPECT_EQ(strokes.value()[2].brush.band, 2);
}

TEST(StrokeFile, ErrorsNameFileAndLine) {
  EXPECT_THAT(refusal("1 2 3\n"), HasSubstr("s.txt:1: a brush line must come before"));
  EXPECT_THAT(refusal("brush 1 1 1 smooth\n1 2\n"), HasSubstr("s.txt:2: a point"));
  EXPECT_THAT(refusal("brush 1 1 1 smooth\n1 2 x\n"), HasSubstr("s.txt:2: 'x' is not a number"));
  EXPECT_THAT(refusal("\nbrush 1 1 1 soft\n"), HasSubstr("s.txt:2: fall-off 'soft'"));
  EXPECT_THAT(refusal("\nbrush 1 1 1 smooth thru\n"), HasSubstr("s.txt:2: 'thru'"));
  EXPECT_THAT(refusal("brush 1 1 1 smooth through through\n"), HasSubstr("s.txt:1: the brush"));
  EXPECT_THAT(refusal("brush 1 1 11 smooth\n0 0 0\n"), HasSubstr("s.txt:1: brush: beta 11"));
  EXPECT_THAT(refusal("brush 1 1 1 smooth\nbrush 1 1 1 smooth\n0 0 0\n"),
              HasSubstr("s.txt:1: the stroke's path has no points"));
  EXPECT_THAT(refusal("# nothing\n"), HasSubstr("s.txt has no strokes"));
}

}  // namespace
}  // namespace burnish
