#include "server/fields/protection.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "server/prepare/prepare.h"

namespace burnish {
namespace {

class ProtectionTest : public testing::Test {
 protected:
  static std::shared_ptr<const PreparedMesh> prepared_for_protection(const TriangleMesh& mesh) {
    PrepareOptions options;
    options.depth = 5;
    return *prepare(mesh, options);
  }

  /// A picture of the sphere from +z, without perspective.
  static LassoRegion right_half(bool through) {
    LassoRegion lasso;
    lasso.view_projection = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1};
    lasso.polygon = {{0, -2}, {2, -2}, {2, 2}, {0, 2}};
    lasso.through = through;
    return lasso;
  }

  Vec3d middle(int32_t cell) const {
    const Vec3d place = morton_point(prepared_->cells[cell]).cast<double>();
    return prepared_->frame.to_file(place + Vec3d::Constant(0.5));
  }
  size_t all() const { return prepared_->cells.size(); }
  size_t count() const { return protection_.cells().size(); }

  std::shared_ptr<const PreparedMesh> prepared_ = prepared_for_protection(make_icosphere(4, 1));
  Protection protection_{*prepared_};
};

TEST_F(ProtectionTest, ALassoTakesTheSideThatFacesTheViewerOrBoth) {
  protection_.apply({right_half(false)});
  EXPECT_GT(count(), all() / 5);
  for (const int32_t cell : protection_.cells()) {
    EXPECT_GE(middle(cell).x(), 0);
    EXPECT_GT(middle(cell).z(), -2 * prepared_->frame.cell_size);
  }
  protection_.apply({right_half(true)});
  EXPECT_NEAR(double(count()), all() / 2.0, 0.05 * double(all()));
}

TEST_F(ProtectionTest, WhatIsReleasedIsNotProtected) {
  protection_.apply({PieceRegion{Vec3d(0, 0, 1)}});
  EXPECT_EQ(count(), all());
  protection_.apply({right_half(true), true});
  for (const int32_t cell : protection_.cells()) EXPECT_LT(middle(cell).x(), 0);
}

TEST_F(ProtectionTest, InvertGrowShrinkAndClearDoWhatTheySay) {
  protection_.apply({right_half(true)});
  const size_t half = count();
  protection_.apply({InvertedRegion{}});
  EXPECT_EQ(count(), all() - half);
  protection_.apply({GrownRegion{2}});
  const size_t grown = count();
  EXPECT_GT(grown, all() - half + 50);
  protection_.apply({GrownRegion{-2}});
  EXPECT_LT(count(), grown);
  protection_.apply({NoRegion{}});
  EXPECT_EQ(count(), 0u);
}

TEST_F(ProtectionTest, CurvatureTakesCellsInItsRange) {
  protection_.apply({CurvatureRegion{1, 1e9}});
  EXPECT_EQ(count(), all()) << "a sphere is convex";
  protection_.apply({CurvatureRegion{1, 1e9}, true});
  protection_.apply({CurvatureRegion{-1e9, -1}});
  EXPECT_EQ(count(), 0u);
}

TEST_F(ProtectionTest, APieceEndsWhereTheSurfaceEnds) {
  TriangleMesh two = make_icosphere(3, 1);
  const TriangleMesh other = make_icosphere(3, 1);
  const auto first = static_cast<uint32_t>(two.vertices.size());
  for (const Vec3d& p : other.vertices) two.vertices.push_back(p + Vec3d(5, 0, 0));
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  prepared_ = prepared_for_protection(two);
  Protection protection(*prepared_);
  protection.apply({PieceRegion{Vec3d(6, 0, 0)}});
  EXPECT_GT(protection.cells().size(), 50u);
  for (const int32_t cell : protection.cells()) EXPECT_GT(middle(cell).x(), 3);
}

}  // namespace
}  // namespace burnish
