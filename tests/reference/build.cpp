#include <algorithm>
#include <cmath>
#include <map>

#include "tests/reference/curvature.h"
#include "tests/reference/reference.h"

namespace burnish::reference {

namespace {

Lattice corner_of(const Lattice& cell, int a) {
  return {cell[0] + (a & 1), cell[1] + ((a >> 1) & 1), cell[2] + (a >> 2)};
}

using Vector8d = Eigen::Matrix<double, 8, 1>;

/// The eight B-splines of a cell and their gradients (rows) at a point. Units: grid.
struct BSplines {
  Vector8d value;
  Eigen::Matrix<double, 8, 3> gradient;
};

BSplines b_splines(const Lattice& cell, const Vec3d& point) {
  BSplines b;
  for (int a = 0; a < 8; ++a) {
    const Lattice corner = corner_of(cell, a);
    Vec3d hat, slope;
    for (int axis = 0; axis < 3; ++axis) {
      hat[axis] = 1 - std::abs(point[axis] - corner[axis]);
      slope[axis] = corner[axis] == cell[axis] ? -1 : 1;
    }
    b.value[a] = hat[0] * hat[1] * hat[2];
    b.gradient.row(a) << slope[0] * hat[1] * hat[2], hat[0] * slope[1] * hat[2],
        hat[0] * hat[1] * slope[2];
  }
  return b;
}

/// Lays the cube around the referenced vertices and measures L.
System frame_of(const TriangleMesh& mesh, int depth) {
  Eigen::AlignedBox3d box;
  double area = 0;
  for (const Triangle& t : mesh.triangles) {
    for (uint32_t v : t) box.extend(mesh.vertices[v]);
    const Vec3d& a = mesh.vertices[t[0]];
    area += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() / 2;
  }
  System system;
  const double cube = box.sizes().maxCoeff() / 0.9;
  system.depth = depth;
  system.cell_size = cube / std::ldexp(1.0, depth);
  system.origin = box.center() - Vec3d::Constant(cube / 2);
  system.length_unit = std::sqrt(area);
  system.vertices = mesh.vertices;
  return system;
}

Vec3d to_grid(const System& system, const Vec3d& point) {
  return snapped((point - system.origin) / system.cell_size);
}

/// An umbilic triangle, such as all of a flat part, has no principal directions. Below this
/// difference, over the larger of |kappa| and 1 (user units), only rounding would choose them.
constexpr double kUmbilicDifference = 1e-9;

bool is_umbilic(const TriangleCurvature& c, double length_unit) {
  const double scale = std::max({std::abs(c.kappa1), std::abs(c.kappa2), 1 / length_unit});
  return c.kappa1 - c.kappa2 <= kUmbilicDifference * scale;
}

/// Adds one piece's integrals. kappas are sums weighted by area until all pieces are in.
void add_piece(Cell& cell, const Polygon& piece, const TriangleCurvature& curvature,
               double length_unit) {
  Matrix8d ell1 = Matrix8d::Zero();
  Matrix8d ell2 = Matrix8d::Zero();
  for (const QuadraturePoint& q : quadrature(piece)) {
    const BSplines b = b_splines(cell.key, q.position);
    const Vector8d along1 = b.gradient * curvature.v1;
    const Vector8d along2 = b.gradient * curvature.v2;
    cell.rho += q.weight * b.value * b.value.transpose();
    ell1 += q.weight * along1 * along1.transpose();
    ell2 += q.weight * along2 * along2.transpose();
    cell.area += q.weight;
    cell.kappa1 += q.weight * curvature.kappa1 * length_unit;
    cell.kappa2 += q.weight * curvature.kappa2 * length_unit;
  }
  // The cell's two alphas may still differ by its other triangles. Half of the whole gradient for
  // each is the average over all choices of directions.
  const bool umbilic = is_umbilic(curvature, length_unit);
  cell.ell1 += umbilic ? Matrix8d((ell1 + ell2) / 2) : ell1;
  cell.ell2 += umbilic ? Matrix8d((ell1 + ell2) / 2) : ell2;
}

double area_of(const Polygon& polygon) {
  double area = 0;
  for (size_t i = 2; i < polygon.size(); ++i)
    area += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]).norm() / 2;
  return area;
}

std::vector<Cell> integrated_cells(const System& system, const TriangleMesh& mesh) {
  const std::vector<TriangleCurvature> curvature = triangle_curvature(mesh);
  std::map<Lattice, Cell> cells;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    if (is_degenerate(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]],
                      mesh.vertices[triangle[2]]))
      continue;
    Polygon corners;
    for (uint32_t v : triangle) corners.push_back(to_grid(system, mesh.vertices[v]));
    cut_at_grid_planes(corners, [&](const Lattice& key, const Polygon& piece) {
      if (!(area_of(piece) > 0)) return;
      Cell& cell = cells[key];
      cell.key = key;
      add_piece(cell, piece, curvature[t], system.length_unit);
    });
  }
  std::vector<Cell> sorted;
  for (auto& [key, cell] : cells) {
    cell.kappa1 /= cell.area;
    cell.kappa2 /= cell.area;
    sorted.push_back(cell);
  }
  return sorted;
}

void number_corners(System& system) {
  for (const Cell& cell : system.cells)
    for (int a = 0; a < 8; ++a) system.corners.push_back(corner_of(cell.key, a));
  std::sort(system.corners.begin(), system.corners.end());
  system.corners.erase(std::unique(system.corners.begin(), system.corners.end()),
                       system.corners.end());
  for (Cell& cell : system.cells) {
    for (int a = 0; a < 8; ++a) {
      const auto found =
          std::lower_bound(system.corners.begin(), system.corners.end(), corner_of(cell.key, a));
      cell.corners[a] = static_cast<int>(found - system.corners.begin());
    }
  }
}

/// A point on a grid plane may take the active cell on either side. The weights on the plane's own
/// corners are the same, and the other weights are zero.
EvaluationRow evaluation_row(const System& system, const Vec3d& point) {
  for (int side = 0; side < 8; ++side) {
    Lattice key;
    bool touches = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool below = (side >> axis) & 1;
      key[axis] = static_cast<int>(std::floor(point[axis])) - below;
      touches = touches && (!below || point[axis] == std::floor(point[axis]));
    }
    const Cell* cell = touches ? system.find_cell(key) : nullptr;
    if (!cell) continue;
    EvaluationRow row;
    row.cell = static_cast<int>(cell - system.cells.data());
    Eigen::Map<Vector8d>(row.weights.data()) = b_splines(key, point).value;
    return row;
  }
  return {};
}

}  // namespace

Vec3d System::cell_centre(const Cell& cell) const {
  return origin + cell_size * Vec3d(cell.key[0] + 0.5, cell.key[1] + 0.5, cell.key[2] + 0.5);
}

const Cell* System::find_cell(const Lattice& key) const {
  const auto found = std::lower_bound(cells.begin(), cells.end(), key,
                                      [](const Cell& c, const Lattice& k) { return c.key < k; });
  return found != cells.end() && found->key == key ? &*found : nullptr;
}

System build(const TriangleMesh& mesh, int depth) {
  System system = frame_of(mesh, depth);
  system.cells = integrated_cells(system, mesh);
  number_corners(system);
  system.evaluation.resize(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles)
    for (uint32_t v : t)
      system.evaluation[v] = evaluation_row(system, to_grid(system, mesh.vertices[v]));
  return system;
}

}  // namespace burnish::reference
