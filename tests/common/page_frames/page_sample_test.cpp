#include "common/page_frames/page_sample.h"

#include <limits>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/limits.h"
#include "common/page_frames/page_corners.h"
#include "tests/common/page_frames/small_pages.h"

namespace burnish {
namespace {

using testing::HasSubstr;

std::vector<int> key_of(const Vec3i& position) {
  return {position.x(), position.y(), position.z()};
}

TEST(PageSample, AVertexOfSeveralPagesHasTheSameValueInEach) {
  PageSampler sampler(PageFrameKind::kVertices);
  sampler.sample(wavy_field(3, 1));
  std::map<std::vector<int>, std::vector<int32_t>> seen;
  int again = 0;
  for (const Page& page : small_pages().pages) {
    const auto steps = sampler.steps(page.id);
    const size_t size = page.positions.size();
    for (size_t v = 0; v < size; ++v) {
      const std::vector<int32_t> value = {steps[v], steps[size + v], steps[2 * size + v]};
      const auto [at, is_new] = seen.emplace(key_of(page.positions[v]), value);
      EXPECT_EQ(at->second, value);
      again += is_new ? 0 : 1;
    }
  }
  EXPECT_GT(again, 1000);
}

TEST(PageSample, VerticesGetTheTrilinearDisplacement) {
  const SmallPages& small = small_pages();
  const auto field = wavy_field(2, 0);
  PageSampler sampler(PageFrameKind::kVertices);
  sampler.sample(field);
  const Page& page = small.pages[3];
  for (size_t v = 0; v < page.positions.size(); ++v) {
    const CellPlace place = cell_place(page.positions[v], small.lattice.bits, small.grid.depth);
    const EvaluationPoint point = {small.grid.find_cell(place.cell), place.local};
    const Vec3f u = evaluate<Vec3f>(small.grid, point, field);
    EXPECT_NEAR(sampler.steps(3)[v], 256 * u.x(), 0.51);
  }
}

TEST(PageSample, CornersGetTheirOwnDisplacement) {
  const SmallPages& small = small_pages();
  const auto field = wavy_field(2, 0);
  PageSampler sampler(PageFrameKind::kCorners);
  sampler.sample(field);
  const PageCorners corners =
      make_page_corners(small.pages[3].positions, small.lattice.bits, small.grid.depth);
  ASSERT_EQ(sampler.shown(3).value_count(), corners.places.size());
  for (size_t i = 0; i < corners.places.size(); ++i) {
    const auto at = std::ranges::find(small.grid.corners, corners.places[i], &GridKey::place);
    const Vec3f& u = field[at - small.grid.corners.begin()];
    EXPECT_NEAR(sampler.steps(3)[i], 256 * u.x(), 0.51);
  }
}

TEST(PageSample, ADisplacementThatIsNotFiniteIsNamed) {
  const SmallPages& small = small_pages();
  const auto evaluation = std::make_shared<PageEvaluation>(make_page_evaluation(
      small.pages[3], small.lattice.bits, small.grid, PageFrameKind::kVertices));
  std::vector<Vec3f> field(small.grid.corners.size(),
                           Vec3f::Constant(std::numeric_limits<float>::infinity()));
  const std::vector<std::shared_ptr<const PageEvaluation>> pages = {evaluation};
  const auto samples = sample_pages(small.grid, pages, field);
  EXPECT_EQ(samples.status().code(), StatusCode::kInternal);
  EXPECT_THAT(samples.status().message(), HasSubstr("value 0 of page 3 is not finite"));
}

TEST(PageSample, TheLargestMoveIsThatOfAPoint) {
  const SmallPages& small = small_pages();
  const PageEvaluation evaluation = make_page_evaluation(small.pages[3], small.lattice.bits,
                                                         small.grid, PageFrameKind::kVertices);
  const std::vector<Vec3f> field(small.grid.corners.size(), Vec3f(3, 0, -4));
  EXPECT_NEAR(largest_move(small.grid, evaluation.points, field), 5, 1e-5);
  EXPECT_EQ(largest_move(small.grid, {}, field), 0);
}

TEST(PageSample, AStrideLooksAtSomePointsAlone) {
  const SmallPages& small = small_pages();
  std::vector<EvaluationPoint> points(7, {0, {0.5F, 0.5F, 0.5F}});
  points[3].cell = kNone;
  const std::vector<Vec3f> field(small.grid.corners.size(), Vec3f(3, 0, -4));
  EXPECT_NEAR(largest_move(small.grid, points, field, 3), 5, 1e-5);
  EXPECT_EQ(largest_move(small.grid, std::span(points).subspan(3, 2), field, 2), 0);
}

TEST(PageSample, TheLargestMoveLeavesOutHeldPoints) {
  const SmallPages& small = small_pages();
  std::vector<EvaluationPoint> points(3, {0, {0.5F, 0.5F, 0.5F}});
  points[1].cell = kNone;
  const std::vector<Vec3f> field(small.grid.corners.size(), Vec3f(3, 0, -4));
  const uint32_t one[] = {0}, both[] = {0, 2};
  EXPECT_NEAR(largest_move(small.grid, points, field, 1, one), 5, 1e-5);
  EXPECT_EQ(largest_move(small.grid, points, field, 1, both), 0);
}

TEST(PageSample, TheGainIsThePowerOfTwoThatHoldsBeta) {
  EXPECT_EQ(gain_exponent(0), 0);
  EXPECT_EQ(gain_exponent(1), 0);
  EXPECT_EQ(gain_exponent(1.01), 1);
  EXPECT_EQ(gain_exponent(2), 1);
  EXPECT_EQ(gain_exponent(kBetaMax), 4);
}

}  // namespace
}  // namespace burnish
