#include <cmath>
#include <utility>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"
#include "common/generate/noise.h"
#include "common/generate/scanner.h"

namespace burnish {

TriangleMesh generate_sheets(const GeneratedScan& wanted) {
  const int side = lattice_size(std::sqrt(static_cast<double>(wanted.vertices) / 2) - 1, 1);
  const uint32_t sheet = (side + 1) * (side + 1);
  TriangleMesh mesh;
  mesh.vertices.resize(2 * sheet);
  constexpr double kGap = 0.0015;  // of the width; a cell at depth 8 is 0.0043
  for (int row = 0; row <= side; ++row)
    for (int column = 0; column <= side; ++column) {
      const Vec3d flat(static_cast<double>(column) / side, static_cast<double>(row) / side, 0);
      const double z = 0.1 * fractal_noise(3 * flat, 4, sub_seed(wanted.seed, 0));
      const double gap = kGap * (1 + 0.8 * gradient_noise(7 * flat, sub_seed(wanted.seed, 1)));
      const uint32_t v = row * (side + 1) + column;
      mesh.vertices[v] = flat + Vec3d(0, 0, z);
      mesh.vertices[sheet + v] = flat + Vec3d(0, 0, z - gap);
    }
  add_lattice_quads(mesh, 0, side + 1, side + 1);
  const size_t upper_triangles = mesh.triangles.size();
  add_lattice_quads(mesh, sheet, side + 1, side + 1);
  for (size_t t = upper_triangles; t < mesh.triangles.size(); ++t)
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);  // the lower sheet faces down
  add_scanner_noise(
      mesh,
      wanted_noise(mesh, wanted,
                   {.white = 0.04 * kGap, .correlated = 0.04 * kGap, .correlation_length = 0.01}),
      sub_seed(wanted.seed, 2));
  round_to_float(mesh);
  return mesh;
}

/// Returns a point of a page of the fan: rows run along the spine (z), columns bend away from it.
static Vec3d fan_point(const Vec3d& direction, double out, double along) {
  const Vec3d across(-direction.y(), direction.x(), 0);
  return direction * out + across * (0.15 * out * out) + Vec3d(0, 0, along);
}

TriangleMesh generate_fan(const GeneratedScan& wanted) {
  constexpr int kPages = 5;
  const int side = lattice_size(std::sqrt(static_cast<double>(wanted.vertices) / kPages), 1);
  const int columns = side + 1;
  TriangleMesh mesh;
  for (int row = 0; row <= side; ++row)
    mesh.vertices.emplace_back(0, 0, static_cast<double>(row) / side);
  for (int page = 0; page < kPages; ++page) {
    const double t = (page - 0.5 * (kPages - 1)) * 0.5;  // tangent of half the angle, -1 to 1
    const Vec3d direction = Vec3d(1 - t * t, 2 * t, 0) / (1 + t * t);
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    const auto index = [=](int column, int row) -> uint32_t {
      return column == 0 ? row : first + row * (columns - 1) + column - 1;
    };
    for (int row = 0; row <= side; ++row)
      for (int column = 1; column <= side; ++column)
        mesh.vertices.push_back(fan_point(direction, static_cast<double>(column) / side,
                                          static_cast<double>(row) / side));
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column)
        add_quad(mesh, index(column, row), index(column + 1, row), index(column + 1, row + 1),
                 index(column, row + 1));
  }
  add_scanner_noise(
      mesh,
      wanted_noise(mesh, wanted, {.white = 5e-4, .correlated = 1e-3, .correlation_length = 0.03}),
      sub_seed(wanted.seed, 0));
  round_to_float(mesh);
  return mesh;
}

/// Makes one scan of the blob as seen along an axis. It overlaps its neighbours, and it is a little
/// out of place, as scans are before their registration is refined.
static TriangleMesh range_scan(int view, int side, const GeneratedScan& wanted) {
  constexpr double kHalfWidth = 1.2;  // 1 would just meet the neighbours
  const Vec3d forward = Vec3d::Unit(view / 2) * (view % 2 == 0 ? 1 : -1);
  const Vec3d right = Vec3d::Unit((view / 2 + 1) % 3);
  const Vec3d up = forward.cross(right);
  const uint64_t own_seed = sub_seed(wanted.seed, 1 + view);
  const Vec3d misplaced = 2e-3 * Vec3d(bounded_normal(own_seed, 0), bounded_normal(own_seed, 1),
                                       bounded_normal(own_seed, 2));
  TriangleMesh scan;
  for (int row = 0; row <= side; ++row)
    for (int column = 0; column <= side; ++column) {
      const double x = kHalfWidth * (2.0 * column / side - 1);
      const double y = kHalfWidth * (2.0 * row / side - 1);
      const Vec3d direction = (forward + right * x + up * y).normalized();
      scan.vertices.push_back(direction * blob_radius(direction, wanted.seed) + misplaced);
    }
  add_lattice_quads(scan, 0, side + 1, side + 1);
  add_scanner_noise(
      scan,
      wanted_noise(scan, wanted, {.white = 5e-4, .correlated = 1e-3, .correlation_length = 0.02}),
      own_seed);
  return scan;
}

TriangleMesh generate_soup(const GeneratedScan& wanted) {
  constexpr int kViews = 6;
  const int side = lattice_size(std::sqrt(static_cast<double>(wanted.vertices) / (kViews * 6)), 1);
  TriangleMesh soup;
  for (int view = 0; view < kViews; ++view) {
    const TriangleMesh scan = range_scan(view, side, wanted);
    for (const Triangle& triangle : scan.triangles) {
      const auto first = static_cast<uint32_t>(soup.vertices.size());
      for (uint32_t v : triangle) soup.vertices.push_back(scan.vertices[v]);
      soup.triangles.push_back({first, first + 1, first + 2});
    }
  }
  round_to_float(soup);
  return soup;
}

}  // namespace burnish
