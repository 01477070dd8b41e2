#include "common/edit/palette.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/edit/brush.h"

namespace burnish {
namespace {

using testing::HasSubstr;

const TransferCurve kCurve = TransferCurve::parse("-20:10,0:80").value();
const Palette kTwo{{{"fine letters", 0xd04040, kCurve}, {"ground", 0x4060d0, TransferCurve(20)}}};

std::string refusal(const std::string& text) {
  const auto palette = parse_palette(text, "p.txt");
  return palette.is_ok() ? "read" : palette.status().message();
}

TEST(PaletteText, ComesBackTheSame) {
  EXPECT_EQ(parse_palette(to_text(kTwo), "p.txt").value(), kTwo);
  EXPECT_EQ(parse_palette_line(to_line(kTwo)).value(), kTwo);
  EXPECT_EQ(parse_palette_line(to_line({})).value(), Palette{});
}

TEST(PaletteText, TakesCommentsAndOneAlphaInPlaceOfACurve) {
  const Palette read = parse_palette("# two\n20 00ff80 soft stone # here\n", "p.txt").value();
  EXPECT_EQ(read, (Palette{{{"soft stone", 0x00ff80, TransferCurve(20)}}}));
}

TEST(PaletteText, IsRefusedWithItsLine) {
  EXPECT_THAT(refusal("20 00ff80\n"), HasSubstr("p.txt:1: a curve's line must be"));
  EXPECT_THAT(refusal("20 red a\n"), HasSubstr("p.txt:1: colour 'red'"));
  EXPECT_THAT(refusal("\n0 00ff80 a\n"), HasSubstr("p.txt:2: alpha 0"));
  EXPECT_THAT(refusal("20 00ff80 a\n30 00ff80 a\n"), HasSubstr("curve 2: the name 'a'"));
  EXPECT_THAT(refusal("1 00ff80 a\n2000 00ff80 b\n"), HasSubstr("limit is a factor of 1000"));
}

TEST(PaletteText, HasEightCurvesAtMost) {
  std::string text;
  for (int i = 0; i < 9; ++i) text += "20 00ff80 curve" + std::to_string(i) + "\n";
  EXPECT_THAT(refusal(text), HasSubstr("9 curves: the limit is 8"));
}

TEST(PaletteText, RefusesNamesThatWouldNotComeBack) {
  for (const char* name : {"a#b", "a;b", " a", "a  b", ""})
    EXPECT_FALSE(check_palette({{{name, 0, TransferCurve(20)}}}).is_ok()) << name;
}

TEST(BrushWords, SayWhatABrushPaints) {
  Brush brush;
  ASSERT_TRUE(parse_painted("band:3", brush).is_ok());
  EXPECT_EQ(brush.band, 3);
  EXPECT_EQ(painted_word(brush), "band:3");
  ASSERT_TRUE(parse_painted("curve:8", brush).is_ok());
  EXPECT_EQ(brush.band, 0);
  EXPECT_EQ(painted_word(brush), "curve:8");
  ASSERT_TRUE(parse_painted("colour", brush).is_ok());
  EXPECT_EQ(brush.curve, 0);
  EXPECT_EQ(painted_word(brush), "colour");
  ASSERT_TRUE(parse_painted("edges", brush).is_ok());
  EXPECT_TRUE(brush.edges);
  EXPECT_EQ(painted_word(brush), "edges");
  ASSERT_TRUE(parse_painted("texture", brush).is_ok());
  EXPECT_FALSE(brush.edges);
  EXPECT_TRUE(brush.texture);
  EXPECT_EQ(painted_word(brush), "texture");
  ASSERT_TRUE(parse_painted("beta", brush).is_ok());
  EXPECT_FALSE(brush.colour);
  EXPECT_FALSE(brush.edges);
  EXPECT_FALSE(brush.texture);
  EXPECT_EQ(painted_word(brush), "beta");
  for (const char* word : {"band", "band:", "band:0", "curve:x", "gain:1"})
    EXPECT_FALSE(parse_painted(word, brush).is_ok()) << word;
}

TEST(BrushWords, ABrushIsConnectedUnlessItsWordsSayThrough) {
  const auto parse = [](std::vector<std::string_view> words, Brush& brush) {
    return parse_brush_words(words, brush);
  };
  Brush brush;
  ASSERT_TRUE(parse({}, brush).is_ok());
  EXPECT_TRUE(brush.connected);
  EXPECT_EQ(brush_words(brush), "");
  ASSERT_TRUE(parse({"through"}, brush).is_ok());
  EXPECT_FALSE(brush.connected);
  EXPECT_EQ(brush_words(brush), " through");
  ASSERT_TRUE(parse({"through", "band:2"}, brush).is_ok());
  EXPECT_EQ(brush_words(brush), " band:2 through");
  ASSERT_TRUE(parse({"curve:1", "connected"}, brush).is_ok());
  EXPECT_EQ(brush_words(brush), " curve:1");
}

TEST(BrushWords, AWordTooManyIsNamed) {
  const auto refusal = [](std::vector<std::string_view> words) {
    Brush brush;
    return parse_brush_words(words, brush).message();
  };
  EXPECT_THAT(refusal({"through", "connected"}), HasSubstr("'through' and 'connected'"));
  EXPECT_THAT(refusal({"beta", "through", "colour"}), HasSubstr("'beta' and 'colour'"));
  EXPECT_THAT(refusal({"thru"}), HasSubstr("'thru'"));
}

TEST(BrushWords, ABrushPaintsOneThing) {
  Stroke stroke{{1, 1, 1, FallOff::kSmooth, 7, 0}, {Vec3d::Zero()}};
  EXPECT_THAT(validate(stroke).message(), HasSubstr("band 7, the limit is 0 to 6"));
  stroke.brush = {1, 1, 1, FallOff::kSmooth, 0, 9};
  EXPECT_THAT(validate(stroke).message(), HasSubstr("curve 9, the limit is 0 to 8"));
  stroke.brush = {1, 1, 1, FallOff::kSmooth, 2, 3};
  EXPECT_THAT(validate(stroke).message(), HasSubstr("band 2 and curve 3"));
}

}  // namespace
}  // namespace burnish
