#include <array>
#include <cmath>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"

namespace burnish {
namespace {

// A plate with a boss around a through hole. The box's longest side is 0.9 of 16. Every flat face
// except the two ends lies a whole number from the centre, so these faces lie in grid planes at
// every depth from 4 on.
constexpr double kHalfLength = 7.2, kHalfWidth = 5;
constexpr double kBottom = -2, kPlateTop = 0, kBossTop = 2;
constexpr double kHoleRadius = 1.5, kBossRadius = 3;

/// A corner of the part's section, on a ray from the axis: at this distance from it, or on the
/// plate's rectangle for radius 0.
struct SectionCorner {
  double radius, z;
};
constexpr double kRectangle = 0;
constexpr std::array<SectionCorner, 6> kSection = {{{kHoleRadius, kBottom},
                                                    {kHoleRadius, kBossTop},
                                                    {kBossRadius, kBossTop},
                                                    {kBossRadius, kPlateTop},
                                                    {kRectangle, kPlateTop},
                                                    {kRectangle, kBottom}}};
constexpr std::array<double, 6> kSectionLengths = {4, 1.5, 2, 3.5, 2, 5};  // to the next corner
constexpr double kSectionLength = 18;
constexpr double kMeanPerimeter = 30;

/// Interpolates in a form that keeps the bits of a coordinate which both ends share.
Vec3d between(const Vec3d& a, const Vec3d& b, double t) {
  return a + (b - a) * t;
}

/// Returns points around the rectangle, counter-clockwise seen from above, `per_side` on each side.
std::vector<Vec3d> rectangle_points(int per_side) {
  const std::array<Vec3d, 4> corners = {
      Vec3d(kHalfLength, -kHalfWidth, 0), Vec3d(kHalfLength, kHalfWidth, 0),
      Vec3d(-kHalfLength, kHalfWidth, 0), Vec3d(-kHalfLength, -kHalfWidth, 0)};
  std::vector<Vec3d> points;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < per_side; ++i) {
      const double t = static_cast<double>(i) / per_side;
      points.push_back(between(corners[side], corners[(side + 1) % 4], t));
    }
  return points;
}

Vec3d corner_point(const SectionCorner& corner, const Vec3d& on_rectangle) {
  const Vec3d flat =
      corner.radius == kRectangle ? on_rectangle : Vec3d(on_rectangle.normalized() * corner.radius);
  return flat + Vec3d(0, 0, corner.z);
}

}  // namespace

TriangleMesh generate_part(const GeneratedScan& wanted) {
  const double spacing =
      std::sqrt(kMeanPerimeter * kSectionLength / static_cast<double>(wanted.vertices));
  std::array<int, 6> steps;
  uint32_t rows = 0;
  for (size_t i = 0; i < steps.size(); ++i) {
    steps[i] = lattice_size(kSectionLengths[i] / spacing, 1);
    rows += steps[i];
  }
  const std::vector<Vec3d> outline =
      rectangle_points(lattice_size(static_cast<double>(wanted.vertices) / rows / 4, 2));
  const auto around = static_cast<uint32_t>(outline.size());

  TriangleMesh mesh;
  for (size_t i = 0; i < kSection.size(); ++i)
    for (int step = 0; step < steps[i]; ++step)
      for (const Vec3d& p : outline) {
        const double t = static_cast<double>(step) / steps[i];
        mesh.vertices.push_back(between(corner_point(kSection[i], p),
                                        corner_point(kSection[(i + 1) % kSection.size()], p), t));
      }
  for (uint32_t row = 0; row < rows; ++row)
    for (uint32_t column = 0; column < around; ++column) {
      const uint32_t below = row * around, above = (row + 1) % rows * around;
      const uint32_t next = (column + 1) % around;
      add_quad(mesh, below + column, above + column, above + next, below + next);
    }
  mesh.has_double_positions = true;
  return mesh;
}

}  // namespace burnish
