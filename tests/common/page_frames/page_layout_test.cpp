#include "common/page_frames/page_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PageLayout, EarlierVerticesOfItsTrianglesPredictAVertexOnce) {
  Page page;
  page.positions.resize(5);
  page.triangles = {{0, 1, 3}, {3, 1, 2}, {2, 4, 3}};
  const PageLayout layout = make_vertex_page_layout(page);
  EXPECT_EQ(layout.value_count(), 5u);
  EXPECT_THAT(layout.predictors[0], IsEmpty());
  EXPECT_THAT(layout.predictors[1], ElementsAre(0));
  EXPECT_THAT(layout.predictors[2], ElementsAre(1));
  EXPECT_THAT(layout.predictors[3], ElementsAre(0, 1, 2));
  EXPECT_THAT(layout.predictors[4], ElementsAre(2, 3));
}

TEST(PageLayout, AVertexWithoutEarlierNeighboursIsPredictedByTheOneBefore) {
  Page page;
  page.positions.resize(6);
  page.triangles = {{0, 1, 2}, {5, 4, 3}};
  EXPECT_THAT(make_vertex_page_layout(page).predictors[3], ElementsAre(2));
}

TEST(PageLayout, CornersOneStepDownPredictACorner) {
  PageCorners corners;
  for (int a = 0; a < kCornersPerCell; ++a)
    corners.places.push_back(morton_key(Vec3i(4, 4, 4) + corner_offset(a)));
  corners.places.push_back(morton_key({9, 9, 9}));
  const PageLayout layout = make_corner_page_layout(corners);
  EXPECT_THAT(layout.predictors[0], IsEmpty());
  EXPECT_THAT(layout.predictors[2], ElementsAre(0));
  EXPECT_THAT(layout.predictors[7], ElementsAre(3, 5, 6));
  EXPECT_THAT(layout.predictors[8], ElementsAre(7));
}

TEST(PageLayout, PredictorsComeEarlier) {
  const PageSampler vertices(PageFrameKind::kVertices), corners(PageFrameKind::kCorners);
  for (const PageSampler* sampler : {&vertices, &corners})
    for (PageId page = 0; page < sampler->page_count(); ++page) {
      const ShownPage shown = sampler->shown(page);
      for (uint32_t value = 1; value < shown.value_count(); ++value) {
        const auto predictors = shown.layout->predictors[value];
        ASSERT_FALSE(predictors.empty());
        ASSERT_LT(std::ranges::max(predictors), value);
      }
    }
}

TEST(PageLayout, TheLargestPageFits) {
  Page page;
  page.positions.resize(kPageVerticesMax);
  for (size_t t = 0; t < kPageTrianglesMax; ++t)
    page.triangles.push_back({static_cast<uint16_t>(t % kPageVerticesMax),
                              static_cast<uint16_t>((7 * t + 1) % kPageVerticesMax),
                              static_cast<uint16_t>((13 * t + 5) % kPageVerticesMax)});
  EXPECT_EQ(make_vertex_page_layout(page).value_count(), kPageVerticesMax);
  PageCorners corners;
  constexpr uint32_t kCornersMax = kCornersPerCell * kPageVerticesMax;
  for (uint32_t i = 0; i < kCornersMax; ++i) corners.places.push_back(i);
  const PageLayout layout = make_corner_page_layout(corners);
  EXPECT_EQ(layout.value_count(), kCornersMax);
  EXPECT_THAT(layout.predictors[kCornersMax - 1], testing::SizeIs(3));
}

}  // namespace
}  // namespace burnish
