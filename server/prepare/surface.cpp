#include "server/prepare/surface.h"

#include <algorithm>
#include <cmath>

namespace burnish {

static constexpr double kUmbilicDifference = 1e-9;  // of the larger curvature, and of 1/L

bool Surface::is_umbilic(const TriangleCurvature& of) const {
  const double largest = std::max({std::abs(of.kappa1), std::abs(of.kappa2), 1 / length_unit});
  return of.kappa1 - of.kappa2 <= kUmbilicDifference * largest;
}

double Surface::integrate(const CellPiece& piece, const TriangleCurvature& of_triangle,
                          CellIntegrator& integrator) const {
  const Vec3i cell = morton_point(piece.cell);
  const Vec3d least = cell.cast<double>();
  Polygon polygon = clip_to_cell(mesh.corners(piece.triangle), cell);
  for (int i = 0; i < polygon.count; ++i) polygon.vertices[i] -= least;
  const double area_before = integrator.area();
  integrator.add(polygon, of_triangle.v1, of_triangle.v2, is_umbilic(of_triangle));
  return integrator.area() - area_before;
}

}  // namespace burnish
