#include "server/fields/connected_dabs.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/generate/generate.h"
#include "common/grid/morton.h"
#include "server/fields/fields.h"
#include "server/fields/paint_checkpoints.h"
#include "server/prepare/prepare.h"

namespace burnish {
namespace {

using testing::Each;
using testing::ElementsAreArray;
using testing::IsEmpty;
using testing::Not;

std::shared_ptr<const PreparedMesh> prepared_at(const TriangleMesh& mesh, int depth) {
  PrepareOptions options;
  options.depth = depth;
  return *prepare(mesh, options);
}

/// Adds a `side` × `side` grid of quads, from a corner along two edges.
void add_grid(const Vec3d& corner, const Vec3d& u, const Vec3d& v, int side, TriangleMesh& mesh) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  const auto width = static_cast<uint32_t>(side + 1);
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) mesh.vertices.push_back(corner + u * i / side + v * j / side);
  for (uint32_t j = 0; j + 1 < width; ++j)
    for (uint32_t i = 0; i + 1 < width; ++i) {
      const uint32_t a = first + j * width + i, b = a + 1, c = a + width, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
}

/// A closed plate over [0, 1]², from z = 0 to `thickness`.
TriangleMesh make_plate(double thickness, int side = 100) {
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, thickness);
  TriangleMesh mesh;
  add_grid(z, x, y, side, mesh);
  add_grid(Vec3d::Zero(), y, x, side, mesh);
  add_grid(Vec3d::Zero(), x, z, side, mesh);
  add_grid(y, z, x, side, mesh);
  add_grid(Vec3d::Zero(), z, y, side, mesh);
  add_grid(x, y, z, side, mesh);
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh) {
  const Eigen::AngleAxisd turn(0.7, Vec3d(1, -2, 0.5).normalized());
  for (Vec3d& vertex : mesh.vertices) vertex = turn * vertex;
  return mesh;
}

std::vector<float> painted_by(const PreparedMesh& prepared, const Stroke& stroke) {
  Fields fields(prepared);
  fields.paint(stroke);
  const auto beta = fields.view().beta;
  return {beta.begin(), beta.end()};
}

Stroke connected(Stroke stroke) {
  stroke.brush.connected = true;
  return stroke;
}

Vec3d middle_of(const PreparedMesh& prepared, size_t c) {
  const Vec3i cell = morton_point(prepared.cells[c]);
  return prepared.frame.to_file(cell.cast<double>() + Vec3d::Constant(0.5));
}

constexpr int kPlateDepth = 6;
constexpr double kBrushRadius = 0.2;

class ConnectedDabsTest : public testing::Test {
 protected:
  /// Returns the paint of cells on one side of the plate.
  std::vector<float> side_of(const std::vector<float>& paint, bool is_top) const {
    std::vector<float> side;
    for (size_t c = 0; c < paint.size(); ++c)
      if ((middle_of(*plate_, c).z() > thickness_ / 2) == is_top) side.push_back(paint[c]);
    return side;
  }
  std::vector<float> top(const std::vector<float>& paint) const { return side_of(paint, true); }
  std::vector<float> bottom(const std::vector<float>& paint) const { return side_of(paint, false); }

  Vec3d on_top(double x, double y) const { return {x, y, thickness_}; }
  Stroke in_the_middle(FallOff fall_off = FallOff::kSmooth) const {
    return {{kBrushRadius, 0.7, 3, fall_off}, {on_top(0.4, 0.5), on_top(0.6, 0.5)}};
  }

  // The cells are as large for every thickness.
  const double thickness_ = 2 * prepared_at(make_plate(0.1), kPlateDepth)->frame.cell_size;
  const std::shared_ptr<const PreparedMesh> plate_ =
      prepared_at(make_plate(thickness_), kPlateDepth);
};

TEST_F(ConnectedDabsTest, AStrokeOnTheTopOfAPlateLeavesItsBottom) {
  for (const FallOff fall_off : {FallOff::kSmooth, FallOff::kConstant}) {
    const auto through = painted_by(*plate_, in_the_middle(fall_off));
    const auto painted = painted_by(*plate_, connected(in_the_middle(fall_off)));
    EXPECT_THAT(bottom(through), Not(Each(1)));
    EXPECT_THAT(bottom(painted), Each(1));
    EXPECT_THAT(top(painted), Not(Each(1)));
    EXPECT_THAT(top(painted), ElementsAreArray(top(through)));
  }
}

TEST_F(ConnectedDabsTest, AStrokeNearTheRimGoesRoundItAndFades) {
  const double from_rim = 0.25 * kBrushRadius;
  const Stroke stroke{{kBrushRadius, 1, 3, FallOff::kLinear}, {on_top(from_rim, 0.5)}};
  const auto painted = painted_by(*plate_, connected(stroke));
  std::vector<std::pair<double, float>> below;  // by the distance from the rim
  for (size_t c = 0; c < painted.size(); ++c) {
    const Vec3d middle = middle_of(*plate_, c);
    if (middle.z() < thickness_ / 2 && std::abs(middle.y() - 0.5) < plate_->frame.cell_size &&
        middle.x() > 0)
      below.emplace_back(middle.x(), painted[c]);
  }
  std::ranges::sort(below);
  EXPECT_GT(below.front().second, 1.5);
  const double reach = SurfaceNear::kDetour * kBrushRadius +
                       SurfaceNear::kSlackCells * plate_->frame.cell_size - from_rim;
  for (const auto& [x, beta] : below)
    if (x > reach) {
      EXPECT_EQ(beta, 1) << x;
    }
  for (size_t i = 0; i + 2 < below.size(); ++i)
    EXPECT_GE(below[i].second + 0.1, below[i + 2].second) << below[i].first;
}

TEST_F(ConnectedDabsTest, WithoutThinWallsConnectedPaintsAsThrough) {
  const std::pair<TriangleMesh, Vec3d> scans[] = {
      {make_icosphere(5, 1), Vec3d(0.6, 0, 0.8)},
      {make_icosphere(2, 1), Vec3d(0.6, 0, 0.8)},
      {make_sheet(200, 1, 0.05), Vec3d(0.5, 0.5, 0.05)},
      {turned(make_sheet(300, 1, 0)), turned(make_sheet(2, 1, 0)).vertices[4]},
      {turned(make_sheet(20, 1, 0)), turned(make_sheet(2, 1, 0)).vertices[4]},
  };
  for (const auto& [mesh, at] : scans) {
    const auto prepared = prepared_at(mesh, kPlateDepth);
    for (const double radius : {0.003, 0.05, 0.1, 0.3}) {
      const Stroke stroke{{radius, 0.5, 2, FallOff::kConstant}, {at}};
      const auto through = painted_by(*prepared, stroke);
      EXPECT_EQ(painted_by(*prepared, connected(stroke)), through) << radius;
      if (radius > 0.01) {
        EXPECT_THAT(through, Not(Each(1)));
      }
    }
  }
}

TEST_F(ConnectedDabsTest, PausesLeaveNoTrace) {
  Fields fields(*plate_);
  const Stroke stroke = connected(in_the_middle());
  ConnectedDabs at_once = fields.connected_dabs(stroke.brush, dab_centres(stroke));
  ConnectedDabs in_pieces = fields.connected_dabs(stroke.brush, dab_centres(stroke));
  EXPECT_TRUE(at_once.advance(1 << 30));
  int pieces = 1;
  while (!in_pieces.advance(1)) ++pieces;
  EXPECT_GT(pieces, 20);
  EXPECT_THAT(in_pieces.left(), ElementsAreArray(at_once.left()));
}

TEST_F(ConnectedDabsTest, ADabBesideTheSurfaceTakesWhatIsNearestWithinItsRadius) {
  Stroke stroke = connected(in_the_middle());
  stroke.path = {on_top(0.5, 0.5) + Vec3d(0, 0, 0.5 * kBrushRadius)};
  const auto above = painted_by(*plate_, stroke);
  EXPECT_THAT(top(above), Not(Each(1)));
  EXPECT_THAT(bottom(above), Each(1));
  stroke.path = {Vec3d(0.5, 0.5, -0.5 * kBrushRadius)};
  const auto below = painted_by(*plate_, stroke);
  EXPECT_THAT(top(below), Each(1));
  EXPECT_THAT(bottom(below), Not(Each(1)));
  stroke.path = {on_top(0.5, 0.5) + Vec3d(0, 0, 1.1 * kBrushRadius)};
  EXPECT_THAT(painted_by(*plate_, stroke), Each(1));
}

TEST_F(ConnectedDabsTest, EachDabBeginsWhereItTouches) {
  Stroke stroke = connected(in_the_middle());
  stroke.path = {on_top(0.5, 0.5), on_top(0.5, 0.5) - Vec3d(0, 0, thickness_)};
  stroke.brush.radius = 4 * thickness_;  // a second dab on the bottom
  const auto painted = painted_by(*plate_, stroke);
  EXPECT_THAT(top(painted), Not(Each(1)));
  EXPECT_THAT(bottom(painted), Not(Each(1)));
}

TEST_F(ConnectedDabsTest, AStrokeTouchesOnlyWhatItReaches) {
  const Fields fields(*plate_);
  const auto is_bottom = [&](int64_t c) {
    return middle_of(*plate_, static_cast<size_t>(c)).z() < thickness_ / 2;
  };
  EXPECT_TRUE(fields.touches(in_the_middle(), is_bottom));
  EXPECT_FALSE(fields.touches(connected(in_the_middle()), is_bottom));
  EXPECT_TRUE(fields.touches(connected(in_the_middle()), std::not_fn(is_bottom)));
}

/// Two sheets that are separate components. The upper one has a dent that comes near the lower one.
TEST(ConnectedDabs, AnotherComponentInTheSameCellsIsNotReachedThroughThem) {
  TriangleMesh mesh = make_sheet(200, 1, 0);
  const double cell = prepared_at(mesh, kPlateDepth)->frame.cell_size;
  TriangleMesh upper = make_sheet(200, 1, -3.7 * cell);
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (const Vec3d& v : upper.vertices) mesh.vertices.emplace_back(v + Vec3d(0, 0, 4 * cell));
  for (const Triangle& t : upper.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  const auto prepared = prepared_at(mesh, kPlateDepth);
  ASSERT_THAT(prepared->sheets, Not(IsEmpty()));
  const Stroke stroke{{0.25, 1, 3, FallOff::kConstant}, {Vec3d(0.3, 0.5, 0)}};
  const auto painted = painted_by(*prepared, connected(stroke));
  const auto through = painted_by(*prepared, stroke);
  int64_t of_upper = 0;
  for (size_t c = 0; c < painted.size(); ++c) {
    const bool is_upper = middle_of(*prepared, c).z() > 1.5 * cell;
    if (is_upper) {
      EXPECT_EQ(painted[c], 1) << middle_of(*prepared, c).transpose();
    }
    of_upper += is_upper && through[c] != 1;
    if (middle_of(*prepared, c).z() < 0.6 * cell) {
      EXPECT_EQ(painted[c], through[c]);
    }
  }
  EXPECT_GT(of_upper, 10);
}

TEST(PaintHash, StrokesThroughWallsKeepTheirHashAndConnectedOnesHaveAnother) {
  const Stroke stroke{{0.5, 0.75, 2, FallOff::kSharp}, {Vec3d(1, 2, 3), Vec3d(4, 5, 6)}};
  EXPECT_EQ(hash_of(stroke), 4539012849406782290u);  // as 0.1.0 had it
  EXPECT_NE(hash_of(connected(stroke)), hash_of(stroke));
}

}  // namespace
}  // namespace burnish
