#include "common/edit/edit_words.h"

#include <gtest/gtest.h>

namespace burnish {
namespace {

EditWords words(Change change) {
  return words_of({"id", std::move(change)});
}

EditWords words(Brush brush) {
  return words(Stroke{brush, {{0, 0, 0}, {1, 0, 0}}});
}

TEST(EditWords, OfAStrokeNameWhatTheBrushDoes) {
  Brush brush{.radius = 0.00469196, .strength = 0.5, .beta = 0, .connected = true};
  EXPECT_EQ(words(brush).name, "Smooth stroke");
  EXPECT_EQ(words(brush).details, "β 0, brush strength 0.5, 2 points");
  EXPECT_EQ(words(brush).radius, 0.00469196);
  brush.beta = 1;
  EXPECT_EQ(words(brush).name, "Restore stroke");
  brush.beta = 2.5;
  EXPECT_EQ(words(brush).name, "Sharpen stroke");
  brush.colour = true;
  EXPECT_EQ(words(brush).name, "Sharpen colours stroke");
  brush.connected = false;
  EXPECT_EQ(words(brush).details, "β 2.5, brush strength 0.5, 2 points, through walls");
}

TEST(EditWords, OfAStrokeNameWhatItPaints) {
  EXPECT_EQ(words(Brush{.radius = 1, .beta = 2, .band = 3}).name, "Stroke of band 3");
  EXPECT_EQ(words(Brush{.radius = 1, .curve = 1}).name, "Stroke of curve 1");
  EXPECT_EQ(words(Brush{.radius = 1, .beta = 0.5, .edges = true}).name, "Denoise stroke");
  EXPECT_EQ(words(Brush{.radius = 1, .beta = 0, .edges = true}).name, "Keep stroke");
  EXPECT_EQ(words(Brush{.radius = 1, .beta = 0, .texture = true}).name, "Fade texture stroke");
}

TEST(EditWords, OfSettingsNameThePanel) {
  EXPECT_EQ(words(SetGradientScale{0.25}).name, "Gradient scale 0.25");
  EXPECT_EQ(words(SetTransferCurve{TransferCurve(50)}).name, "Fidelity α 50");
  const EditWords curve = words(SetTransferCurve{*TransferCurve::create({{-1, 5}, {1, 50}})});
  EXPECT_EQ(curve.name, "Transfer curve");
  EXPECT_EQ(curve.details, "2 points, contrast 10");
  EXPECT_EQ(words(SetControls{{true, 0.5, true}}).name, "Limits");
  EXPECT_EQ(words(SetControls{{true, 0.5, true}}).details, "rims pinned, at most 0.5, volume kept");
  EXPECT_EQ(words(SetEdges{}).name, "Edges not kept");
}

TEST(EditWords, OfARegionSayHowItWasChosen) {
  EXPECT_EQ(words(Protect{CurvatureRegion{-1, 20}}).name, "Protect by curvature");
  EXPECT_EQ(words(Protect{CurvatureRegion{-1, 20}}).details, "-1 to 20");
  EXPECT_EQ(words(Protect{LassoRegion{}, true}).name, "Release by lasso");
  EXPECT_EQ(words(Protect{PieceRegion{}}).name, "Protect piece");
}

TEST(EditWords, OfACheckpointAreItsName) {
  EXPECT_EQ(words(SetCheckpoint{"before lunch"}).name, "before lunch");
}

TEST(EditWords, OfOtherKindsAreTheSummary) {
  EXPECT_EQ(words(SetCellFields{}).name, "Fields of 0 cells");
  EXPECT_EQ(words(Undo{}).name, "Undo");
}

}  // namespace
}  // namespace burnish
