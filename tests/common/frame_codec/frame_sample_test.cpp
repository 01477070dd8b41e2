#include "common/frame_codec/frame_sample.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/frame_codec/small_scan.h"

namespace burnish {
namespace {

TEST(FrameSample, CoefficientsAreRoundedToTheNearest256thOfACell) {
  const auto layout = small_layout(FrameContent::kCoefficients);
  const auto displacement = wavy_displacement(small_scan().grid, 3, 0.4);
  const FrameSample sample = sample_of(*layout, displacement);
  for (int tile = 0; tile < layout->tile_count(); ++tile) {
    const int begin = layout->tile_begin(tile), size = layout->tile_size(tile);
    for (int i = 0; i < size; ++i)
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_LE(std::abs(sample.tile(*layout, tile)[axis * size + i] -
                           256 * displacement[layout->source[begin + i]][axis]),
                  0.5);
  }
}

TEST(FrameSample, OfVerticesItIsTheEvaluatedDisplacement) {
  const SmallScan& scan = small_scan();
  const auto layout = small_layout(FrameContent::kVertices);
  const auto displacement = wavy_displacement(scan.grid, 3, 0.4);
  const FrameSample sample = sample_of(*layout, displacement);
  const int last = layout->tile_count() - 1, size = layout->tile_size(last);
  for (int i = 0; i < size; ++i) {
    const int32_t vertex = layout->source[layout->tile_begin(last) + i];
    const Vec3d u = evaluate<Vec3d>(scan.grid, scan.points[vertex], displacement);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_LE(std::abs(sample.tile(*layout, last)[axis * size + i] - 256 * u[axis]), 0.5);
  }
}

TEST(FrameSample, FloatsGiveTheSameSteps) {
  const auto layout = small_layout(FrameContent::kCoefficients);
  std::vector<Vec3f> floats;
  std::vector<Vec3d> doubles;
  for (const Vec3d& u : wavy_displacement(small_scan().grid, 3, 0.4)) {
    floats.push_back(u.cast<float>());
    doubles.push_back(floats.back().cast<double>());
  }
  const auto sample = sample_displacement<Vec3f>(*layout, small_scan().frame_mesh(), floats);
  EXPECT_EQ(sample->steps, sample_of(*layout, doubles).steps);
}

TEST(FrameSample, RunawayDisplacementsAreCutOff) {
  const auto layout = small_layout(FrameContent::kCoefficients);
  std::vector<Vec3d> displacement(small_scan().grid.corners.size(), Vec3d::Zero());
  displacement[layout->source[0]] = Vec3d(1e30, -1e30, 5);
  const FrameSample sample = sample_of(*layout, displacement);
  const int size = layout->tile_size(0);
  EXPECT_EQ(sample.steps[0], 1 << 28);
  EXPECT_EQ(sample.steps[size], -(1 << 28));
  EXPECT_EQ(sample.steps[2 * size], 5 * 256);
}

TEST(FrameSample, NotANumberIsRefusedByCorner) {
  const auto layout = small_layout(FrameContent::kCoefficients);
  auto displacement = wavy_displacement(small_scan().grid, 1, 0);
  const int32_t corner = layout->source[3000];
  displacement[corner].y() = std::numeric_limits<double>::quiet_NaN();
  const auto sample = sample_displacement<Vec3d>(*layout, small_scan().frame_mesh(), displacement);
  ASSERT_FALSE(sample.is_ok());
  EXPECT_THAT(sample.status().message(), testing::HasSubstr("corner " + std::to_string(corner)));
}

}  // namespace
}  // namespace burnish
