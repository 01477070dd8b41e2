#include "common/frame_codec/frame_layout.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

std::vector<float> largest_weights() {
  const SmallScan& scan = small_scan();
  std::vector<float> largest(scan.grid.corners.size(), 0);
  for (const EvaluationPoint& point : scan.points) {
    const auto weights = trilinear_weights(point.local);
    for (int a = 0; a < kCornersPerCell; ++a) {
      float& so_far = largest[scan.grid.cell_corners[point.cell][a]];
      so_far = std::max(so_far, weights[a]);
    }
  }
  return largest;
}

TEST(FrameLayout, CoefficientsAreTheCornersThatWeighOnAVertex) {
  const auto layout = small_layout(FrameContent::kCoefficients);
  const auto largest = largest_weights();
  std::vector<int32_t> weighing;
  for (int32_t corner = 0; corner < static_cast<int32_t>(largest.size()); ++corner)
    if (largest[corner] > 0) weighing.push_back(corner);
  EXPECT_EQ(layout->source, weighing);
  EXPECT_GT(layout->tile_count(), 2);
}

TEST(FrameLayout, ACornerWithoutWeightIsLeftOut) {
  const SmallScan& scan = small_scan();
  // A vertex on the lower face of its cell has no weight at the four upper corners.
  const std::vector<EvaluationPoint> points = {{.cell = 5, .local = {0.5F, 0.5F, 0}}};
  const FrameLayout layout = make_coefficient_layout({scan.grid, points});
  EXPECT_EQ(layout.value_count(), 4);
}

TEST(FrameLayout, SlackTimesTheLargestWeightIsAtMostAnEighth) {
  const auto layout = small_layout(FrameContent::kCoefficients);
  const auto largest = largest_weights();
  int above_one = 0;
  for (int i = 0; i < layout->value_count(); ++i) {
    if (layout->slack[i] == 1) continue;
    ++above_one;
    EXPECT_LE(layout->slack[i] * largest[layout->source[i]], 0.125F);
  }
  EXPECT_GT(above_one, layout->value_count() / 50);
}

TEST(FrameLayout, VerticesAreEachOnceAndAlongTheCells) {
  const auto layout = small_layout(FrameContent::kVertices);
  const SmallScan& scan = small_scan();
  EXPECT_EQ(std::set<int32_t>(layout->source.begin(), layout->source.end()).size(),
            scan.mesh.vertices.size());
  for (int i = 1; i < layout->value_count(); ++i)
    EXPECT_LE(scan.points[layout->source[i - 1]].cell, scan.points[layout->source[i]].cell);
}

TEST(FrameLayout, VerticesOutsideTheGridAreLeftOut) {
  const SmallScan& scan = small_scan();
  std::vector<EvaluationPoint> points = scan.points;
  points[17] = {};
  const FrameLayout layout = make_vertex_layout({scan.grid, points});
  EXPECT_EQ(layout.source.size(), points.size() - 1);
  EXPECT_EQ(std::ranges::count(layout.source, 17), 0);
}

TEST(FrameLayout, PredictorsNameEarlierValuesOfTheTileOrZero) {
  for (const auto content : {FrameContent::kCoefficients, FrameContent::kVertices}) {
    const auto layout = small_layout(content);
    for (int i = 0; i < layout->value_count(); ++i)
      for (const uint16_t from :
           {layout->predictors[i].a, layout->predictors[i].b, layout->predictors[i].c})
        EXPECT_TRUE(from < i % kTileValues || from == kTileValues);
  }
}

TEST(FrameLayout, AnotherMeshHasAnotherFingerprint) {
  const SmallScan& scan = small_scan();
  std::vector<EvaluationPoint> points = scan.points;
  points.pop_back();
  const FrameMesh fewer = {scan.grid, points};
  EXPECT_NE(make_vertex_layout(fewer).fingerprint,
            small_layout(FrameContent::kVertices)->fingerprint);
  EXPECT_NE(small_layout(FrameContent::kCoefficients)->fingerprint,
            small_layout(FrameContent::kVertices)->fingerprint);
  EXPECT_EQ(make_vertex_layout(scan.frame_mesh()).fingerprint,
            small_layout(FrameContent::kVertices)->fingerprint);
}

TEST(FrameLayout, FewVerticesAreSentAsVerticesAndManyAsCoefficients) {
  const SmallScan& scan = small_scan();
  const std::span<const EvaluationPoint> few = std::span(scan.points).first(20);
  EXPECT_EQ(make_smaller_layout({scan.grid, few}).content, FrameContent::kVertices);
  std::vector<EvaluationPoint> many;
  for (int copy = 0; copy < 20; ++copy)
    many.insert(many.end(), scan.points.begin(), scan.points.end());
  EXPECT_EQ(make_smaller_layout({scan.grid, many}).content, FrameContent::kCoefficients);
}

}  // namespace
}  // namespace burnish
