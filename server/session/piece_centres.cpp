#include "server/session/piece_centres.h"

#include <map>

#include "common/grid/morton.h"

namespace burnish {

using Vec4d = Eigen::Vector4d;  // a sum of places by area, and the area

std::vector<Vec3f> piece_centres(const PreparedMesh& prepared, const SparseGrid& grid) {
  constexpr double kAreaLeast = 1e-30;  // a piece of slivers has a centre too
  std::map<int32_t, Vec4d> pieces;
  for (size_t cell = 0; cell < grid.cells.size(); ++cell) {
    const Vec3d middle = morton_point(grid.cells[cell].place).cast<double>().array() + 0.5;
    Vec4d share;
    share << middle, 1;
    const auto sum = pieces.try_emplace(grid.cells[cell].component, Vec4d::Zero()).first;
    sum->second += (prepared.curvature[cell].area + kAreaLeast) * share;
  }
  std::vector<Vec3f> centres(grid.corners.size());
  for (size_t corner = 0; corner < centres.size(); ++corner) {
    const Vec4d& sum = pieces.at(grid.corners[corner].component);
    centres[corner] = (sum.head<3>() / sum.w()).cast<float>();
  }
  return centres;
}

}  // namespace burnish
