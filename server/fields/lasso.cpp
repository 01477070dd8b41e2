#include "server/fields/lasso.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "common/grid/sparse_grid.h"
#include "server/fields/cell_layers.h"

namespace burnish {
namespace {

using Eigen::Vector2d;
using Eigen::Vector4d;

bool is_inside(const std::vector<Vector2d>& polygon, const Vector2d& p) {
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vector2d &a = polygon[i], &b = polygon[j];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) inside = !inside;
  }
  return inside;
}

constexpr double kSamplesPerCell = 2;

int samples_along(const Vec3d& side) {
  return std::max(1, static_cast<int>(std::ceil(kSamplesPerCell * side.norm())));
}

/// Sums the normals of the triangles in each cell, from samples half a cell apart. A cell
/// that no sample meets has the normal of its neighbours.
std::vector<Vec3f> cell_normals(const PreparedMesh& prepared) {
  std::vector<Vec3f> normals(prepared.cells.size(), Vec3f::Zero());
  for (const Triangle& triangle : prepared.triangles) {
    const Vec3d a = prepared.frame.to_grid(prepared.vertices[triangle[0]]);
    const Vec3d side = prepared.frame.to_grid(prepared.vertices[triangle[1]]) - a;
    const Vec3d other = prepared.frame.to_grid(prepared.vertices[triangle[2]]) - a;
    const int along = samples_along(side), across = samples_along(other);
    const Vec3f share = (side.cross(other) / (double(along) * across)).cast<float>();
    for (int i = 0; i < along; ++i)
      for (int j = 0; j < across; ++j) {
        double u = (i + 0.5) / along, v = (j + 0.5) / across;
        if (u + v > 1) u = 1 - u, v = 1 - v;  // the other half of the parallelogram
        const Vec3d place = a + u * side + v * other;
        const int32_t cell = find_cell(prepared, place.array().floor().cast<int>());
        if (cell != kNone) normals[cell] += share;
      }
  }
  const std::vector<Vec3f> sampled = normals;
  for (size_t c = 0; c < normals.size(); ++c)
    if (sampled[c].isZero(0))
      for (const int32_t other : neighbours_of(prepared, static_cast<int32_t>(c)))
        normals[c] += sampled[other];
  return normals;
}

/// A picture's camera, as its matrix says.
class Sight {
 public:
  explicit Sight(const std::array<double, 16>& rows)
      : matrix_(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(rows.data())) {}

  Vector4d clip(const Vec3d& p) const { return matrix_ * p.homogeneous(); }

  /// Returns the direction away from the viewer through a place, given as clip / w.
  Vec3d away(const Vec3d& place) const {
    const auto row = [&](int axis) {
      return Vec3d(matrix_.row(axis).head<3>() - place[axis] * matrix_.row(3).head<3>());
    };
    const Vec3d along = row(0).cross(row(1));
    return row(2).dot(along) < 0 ? Vec3d(-along) : along;
  }

 private:
  Eigen::Matrix4d matrix_;
};

}  // namespace

std::vector<uint8_t> cells_in_lasso(const PreparedMesh& prepared, const LassoRegion& lasso) {
  const Sight sight(lasso.view_projection);
  std::vector<Vec3f> normals;
  if (!lasso.through) normals = cell_normals(prepared);
  std::vector<uint8_t> chosen(prepared.cells.size(), 0);
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < chosen.size(); ++c) {
    const Vec3i cell = morton_point(prepared.cells[c]);
    const Vec3d middle = prepared.frame.to_file(cell.cast<double>() + Vec3d::Constant(0.5));
    const Vector4d clip = sight.clip(middle);
    if (!(clip.w() > 0)) continue;
    const Vec3d place = clip.head<3>() / clip.w();
    if (!is_inside(lasso.polygon, place.head<2>())) continue;
    chosen[c] = lasso.through || normals[c].cast<double>().dot(sight.away(place)) <= 0;
  }
  return chosen;
}

}  // namespace burnish
