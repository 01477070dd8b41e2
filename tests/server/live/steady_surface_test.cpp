#include "server/live/steady_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"
#include "server/solver/hierarchy/hierarchy.h"

namespace burnish {
namespace {

constexpr float kDistance = 0.01F;

/// A sphere at depth 6: many bricks.
class SteadySurfaceTest : public testing::Test {
 protected:
  SteadySurfaceTest() {
    PrepareOptions options;
    options.depth = 6;
    prepared_ = *prepare(make_icosphere(5, 1), options);
    hierarchy_ = make_hierarchy(*prepared_);
    displacement_.assign(grid().corners.size(), Vec3f(0.25F, 0, 0));
    steady_.emplace(grid(), prepared_->evaluation, kDistance, Quota::Share());
    (void)steady_->show(displacement_);
    steady_->rest();
  }
  const SparseGrid& grid() const { return hierarchy_->at(hierarchy_->finest).grid; }
  /// Moves the corners with i below `end` by so many cells.
  void move(int end, float by) {
    for (size_t c = 0; c < displacement_.size(); ++c)
      if (morton_point(grid().corners[c].place).x() < end) displacement_[c].x() += by;
  }
  size_t moved_corners(std::span<const Vec3f> shown) const {
    size_t moved = 0;
    for (const Vec3f& u : shown) moved += u != Vec3f(0.25F, 0, 0);
    return moved;
  }

  std::shared_ptr<const PreparedMesh> prepared_;
  std::shared_ptr<const Hierarchy> hierarchy_;
  std::vector<Vec3f> displacement_;
  std::optional<SteadySurface> steady_;
};

TEST_F(SteadySurfaceTest, ASmallMoveIsNotShown) {
  move(64, 0.9F * kDistance);
  EXPECT_EQ(moved_corners(steady_->show(displacement_)), 0u);
  EXPECT_TRUE(steady_->is_behind());
}

TEST_F(SteadySurfaceTest, SmallMovesAddUpUntilTheyAreShown) {
  move(64, 0.9F * kDistance);
  (void)steady_->show(displacement_);
  move(64, 0.9F * kDistance);
  EXPECT_EQ(moved_corners(steady_->show(displacement_)), displacement_.size());
  EXPECT_FALSE(steady_->is_behind());
}

TEST_F(SteadySurfaceTest, AMoveIsShownWhereItIsAndNotFarFromThere) {
  move(64, 0.5F * kDistance);
  move(16, 10 * kDistance);
  const auto shown = steady_->show(displacement_);
  const size_t moved = moved_corners(shown);
  EXPECT_GT(moved, 0u);
  EXPECT_LT(2 * moved, displacement_.size());
  for (const EvaluationPoint& point : prepared_->evaluation) {
    const Vec3f wanted = evaluate(grid(), point, std::span<const Vec3f>(displacement_));
    ASSERT_LE((evaluate(grid(), point, shown) - wanted).norm(), kDistance);
  }
}

TEST_F(SteadySurfaceTest, WhatHasMovedGoesOnUntilItRests) {
  move(64, 10 * kDistance);
  (void)steady_->show(displacement_);
  move(64, 0.1F * kDistance);
  (void)steady_->show(displacement_);
  EXPECT_FALSE(steady_->is_behind());
  steady_->rest();
  move(64, 0.1F * kDistance);
  (void)steady_->show(displacement_);
  EXPECT_TRUE(steady_->is_behind());
}

TEST_F(SteadySurfaceTest, AllIsShownOnDemand) {
  move(64, 0.1F * kDistance);
  const auto shown = steady_->show_all(displacement_);
  EXPECT_THAT(shown, testing::ElementsAreArray(displacement_));
  EXPECT_FALSE(steady_->is_behind());
}

}  // namespace
}  // namespace burnish
