#include "server/session/corner_normals.h"

#include "common/evaluation/evaluation.h"

namespace burnish {
namespace {

constexpr int kSmoothingPasses = 4;

using Vec4f = Eigen::Vector4f;  // a sum of normals by area, and the area

/// Gives a third of each triangle to each of its vertices, and from there to the corners around.
std::vector<Vec4f> gather(const PreparedMesh& prepared, const SparseGrid& grid) {
  std::vector<Vec4f> sums(grid.corners.size(), Vec4f::Zero());
  const double scale = 1 / (6 * prepared.frame.cell_size * prepared.frame.cell_size);
  for (const Triangle& triangle : prepared.triangles) {
    const Vec3d& a = prepared.vertices[triangle[0]];
    const Vec3d normal =
        scale *
        (prepared.vertices[triangle[1]] - a).cross(prepared.vertices[triangle[2]] - a).eval();
    Vec4f share;
    share << normal.cast<float>(), static_cast<float>(normal.norm());
    for (const uint32_t v : triangle) {
      const EvaluationPoint& point = prepared.evaluation[v];
      if (point.cell == kNone) continue;
      const auto weights = trilinear_weights(point.local);
      for (int corner = 0; corner < kCornersPerCell; ++corner)
        sums[grid.cell_corners[point.cell][corner]] += weights[corner] * share;
    }
  }
  return sums;
}

/// Spreads each corner's sum over the corners of its cells.
void smooth(const SparseGrid& grid, std::vector<Vec4f>& sums) {
  std::vector<Vec4f> means(grid.cells.size());
#pragma omp parallel for schedule(static)
  for (size_t cell = 0; cell < means.size(); ++cell) {
    Vec4f sum = Vec4f::Zero();
    for (const int32_t corner : grid.cell_corners[cell]) sum += sums[corner];
    means[cell] = sum / kCornersPerCell;
  }
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < sums.size(); ++corner) {
    sums[corner].setZero();
    for (const int32_t cell : grid.cells_of_corner[corner])
      if (cell != kNone) sums[corner] += means[cell];
  }
}

}  // namespace

std::vector<Vec3f> corner_normals(const PreparedMesh& prepared, const SparseGrid& grid) {
  std::vector<Vec4f> sums = gather(prepared, grid);
  for (int pass = 0; pass < kSmoothingPasses; ++pass) smooth(grid, sums);
  std::vector<Vec3f> normals(sums.size());
  for (size_t corner = 0; corner < sums.size(); ++corner)
    normals[corner] =
        sums[corner].w() > 0 ? Vec3f(sums[corner].head<3>() / sums[corner].w()) : Vec3f::Zero();
  return normals;
}

}  // namespace burnish
