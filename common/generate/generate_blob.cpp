#include <cmath>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"
#include "common/generate/noise.h"
#include "common/generate/scanner.h"

namespace burnish {
namespace {

/// The lattice points (i, j, k) in 0..n on the surface of a cube, numbered by layers of k.
class CubeSurface {
 public:
  explicit CubeSurface(int n) : n_(n) {}

  uint32_t index(int i, int j, int k) const {
    const int whole_layer = (n_ + 1) * (n_ + 1), ring = 4 * n_;
    if (k == 0) return j * (n_ + 1) + i;
    const int layer = whole_layer + (k - 1) * ring;
    if (k == n_) return layer + j * (n_ + 1) + i;
    if (j == 0) return layer + i;
    if (i == n_) return layer + n_ + j;
    if (j == n_) return layer + 3 * n_ - i;
    return layer + 4 * n_ - j;
  }

 private:
  int n_;
};

}  // namespace

/// Maps a point of the surface of the cube [-1, 1]³ to the unit sphere. This closed form uses only
/// square roots and spreads the lattice evenly (areas within a factor of 1.5).
static Vec3d sphere_of_cube(const Vec3d& p) {
  const Vec3d q = p.cwiseProduct(p);
  const auto stretch = [](double u, double v) { return std::sqrt(1 - u / 2 - v / 2 + u * v / 3); };
  return Vec3d(p.x() * stretch(q.y(), q.z()), p.y() * stretch(q.z(), q.x()),
               p.z() * stretch(q.x(), q.y()))
      .normalized();
}

double blob_radius(const Vec3d& direction, uint64_t seed) {
  const double lumps = 0.45 * gradient_noise(1.4 * direction, sub_seed(seed, 0)) +
                       0.12 * gradient_noise(3.5 * direction, sub_seed(seed, 1));
  const double creases = 0.07 * std::abs(gradient_noise(5 * direction, sub_seed(seed, 2)));
  const double detail = 0.015 * fractal_noise(14 * direction, 3, sub_seed(seed, 3));
  return 1 + lumps - creases + detail;
}

TriangleMesh generate_blob(const GeneratedScan& wanted) {
  const int n = lattice_size(std::sqrt((static_cast<double>(wanted.vertices) - 2) / 6), 1);
  const CubeSurface surface(n);
  TriangleMesh mesh;
  mesh.vertices.resize(6 * static_cast<size_t>(n) * n + 2);
#pragma omp parallel for schedule(dynamic, 1)
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j) {
      const bool whole_row = k == 0 || k == n || j == 0 || j == n;
      for (int i = 0; i <= n; i += whole_row ? 1 : n) {
        const Vec3d direction = sphere_of_cube(Vec3d(i, j, k) * (2.0 / n) - Vec3d::Ones());
        mesh.vertices[surface.index(i, j, k)] = direction * blob_radius(direction, wanted.seed);
      }
    }
  for (int u = 0; u < n; ++u)
    for (int v = 0; v < n; ++v) {
      const auto quad = [&](auto at) {
        add_quad(mesh, at(u, v), at(u + 1, v), at(u + 1, v + 1), at(u, v + 1));
      };
      quad([&](int a, int b) { return surface.index(b, a, 0); });
      quad([&](int a, int b) { return surface.index(a, b, n); });
      quad([&](int a, int b) { return surface.index(a, 0, b); });
      quad([&](int a, int b) { return surface.index(b, n, a); });
      quad([&](int a, int b) { return surface.index(0, b, a); });
      quad([&](int a, int b) { return surface.index(n, a, b); });
    }
  add_scanner_noise(
      mesh,
      wanted_noise(mesh, wanted, {.white = 4e-4, .correlated = 4e-4, .correlation_length = 0.02}),
      sub_seed(wanted.seed, 4));
  round_to_float(mesh);
  return mesh;
}

}  // namespace burnish
