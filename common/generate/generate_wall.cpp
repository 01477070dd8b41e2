#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

#include "common/generate/generate_kinds.h"
#include "common/generate/lattice.h"
#include "common/generate/noise.h"
#include "common/generate/scanner.h"

namespace burnish {

namespace {

constexpr double kVolumeHalfWidth = 1.1;  // of the volume
constexpr double kVerticesPerArea = 10;   // per square of the volume's side
constexpr int kThreshold = 180;           // density of the surface
constexpr int kDensityMost = 420;         // of the wall's middle, if it is dense everywhere
constexpr double kWallVoxels = 1.5;       // from the middle to where nothing is left

/// The density of a thin wall as a tomograph measures it: whole numbers on a cubic lattice. In
/// places the wall is too thin to be seen.
class Volume {
 public:
  Volume(int side, uint64_t seed) : side_(side), density_(size_t(side) * side * side) {
#pragma omp parallel for schedule(dynamic, 1)
    for (int k = 0; k < side; ++k)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) density_[index(i, j, k)] = measured(i, j, k, seed);
  }

  int side() const {
    return side_;
  }
  uint32_t index(int i, int j, int k) const {
    return (uint32_t(k) * side_ + j) * side_ + i;
  }
  int density(uint32_t point) const {
    return density_[point];
  }

  Vec3d place(uint32_t point) const {
    const auto side = static_cast<uint32_t>(side_);
    return place(static_cast<int>(point % side), static_cast<int>(point / side % side),
                 static_cast<int>(point / side / side));
  }

 private:
  double voxel() const {
    return 2 * kVolumeHalfWidth / (side_ - 1);
  }
  Vec3d place(int i, int j, int k) const {
    return Vec3d(i, j, k) * voxel() - Vec3d::Constant(kVolumeHalfWidth);
  }

  int16_t measured(int i, int j, int k, uint64_t seed) const {
    const Vec3d p = place(i, j, k);
    const double reach = kWallVoxels * voxel(), radius = p.norm();
    if (radius < 0.3 || radius > 1.05) return 0;
    const Vec3d direction = p / radius;
    const double outside = radius - 0.7 - 0.2 * gradient_noise(1.4 * direction, sub_seed(seed, 0)) -
                           0.03 * gradient_noise(7 * direction, sub_seed(seed, 1));
    if (std::abs(outside) >= reach) return 0;
    const double dense = 0.7 + 0.9 * gradient_noise(5 * p, sub_seed(seed, 2)) +
                         0.22 * bounded_normal(sub_seed(seed, 3), index(i, j, k));
    const auto density = std::lround(kDensityMost * dense * (1 - std::abs(outside) / reach));
    // Part of the numbers are rounded further, so that some are just the threshold.
    const bool is_coarse = uniform(sub_seed(seed, 4), index(i, j, k)) < 0.5;
    return static_cast<int16_t>(is_coarse ? (density + 10) / 20 * 20 : density);
  }

  int side_;
  std::vector<int16_t> density_;
};

/// Makes the surface of a volume, tetrahedron by tetrahedron. A point whose density is just the
/// threshold is a vertex itself, so that sheets meet there.
class Surface {
 public:
  explicit Surface(const Volume& volume) : volume_(volume) {}

  TriangleMesh make() {
    const int cubes = volume_.side() - 1;
    for (int k = 0; k < cubes; ++k)
      for (int j = 0; j < cubes; ++j)
        for (int i = 0; i < cubes; ++i) add_cube(i, j, k);
    return std::move(mesh_);
  }

 private:
  using Tetrahedron = std::array<uint32_t, 4>;
  using Cut = std::pair<uint32_t, uint32_t>;  // a point inside, and one outside or itself

  bool is_inside(uint32_t point) const { return volume_.density(point) >= kThreshold; }

  // Six tetrahedra around the diagonal, one for each order of the axes.
  void add_cube(int i, int j, int k) {
    constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                   {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int order = 0; order < 6; ++order) {
      std::array<int, 3> at = {i, j, k};
      Tetrahedron points = {volume_.index(i, j, k)};
      for (int step = 0; step < 3; ++step) {
        ++at[kOrders[order][step]];
        points[step + 1] = volume_.index(at[0], at[1], at[2]);
      }
      if (order >= 3) std::swap(points[2], points[3]);  // keeps the turn of all six
      add_tetrahedron(points);
    }
  }

  void add_tetrahedron(Tetrahedron t) {
    // An even permutation brings the points inside to the front.
    int inside = 0;
    for (const uint32_t point : t) inside += is_inside(point);
    if (inside == 0 || inside == 4) return;
    constexpr int kEven[12][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 0, 3, 2},
                                  {1, 3, 2, 0}, {1, 2, 0, 3}, {2, 3, 0, 1}, {2, 0, 1, 3},
                                  {2, 1, 3, 0}, {3, 2, 1, 0}, {3, 1, 0, 2}, {3, 0, 2, 1}};
    for (const auto& order : kEven) {
      const Tetrahedron p = {t[order[0]], t[order[1]], t[order[2]], t[order[3]]};
      int leading = 0;
      while (leading < 4 && is_inside(p[leading])) ++leading;
      if (leading != inside) continue;
      if (inside == 1) add_triangle(cut(p[0], p[1]), cut(p[0], p[2]), cut(p[0], p[3]));
      if (inside == 3) add_triangle(cut(p[0], p[3]), cut(p[1], p[3]), cut(p[2], p[3]));
      if (inside == 2) {
        const Cut a = cut(p[0], p[2]), b = cut(p[0], p[3]);
        const Cut c = cut(p[1], p[3]), d = cut(p[1], p[2]);
        add_triangle(a, b, c);
        add_triangle(a, c, d);
      }
      return;
    }
  }

  void add_triangle(Cut a, Cut b, Cut c) {
    if (a != b && b != c && c != a)
      mesh_.triangles.push_back({vertex_at(a), vertex_at(b), vertex_at(c)});
  }

  // Returns where the surface passes between a point inside and one outside.
  Cut cut(uint32_t inside, uint32_t outside) const {
    return {inside, volume_.density(inside) == kThreshold ? inside : outside};
  }

  uint32_t vertex_at(const Cut& cut) {
    const auto [inside, outside] = cut;
    const auto [found, is_new] = vertices_.try_emplace(
        uint64_t(inside) << 32 | outside, static_cast<uint32_t>(mesh_.vertices.size()));
    if (!is_new) return found->second;
    const int here = volume_.density(inside), there = volume_.density(outside);
    const double part = inside == outside ? 0 : double(here - kThreshold) / (here - there);
    const Vec3d a = volume_.place(inside);
    mesh_.vertices.push_back(a + part * (volume_.place(outside) - a));
    return found->second;
  }

  const Volume& volume_;
  TriangleMesh mesh_;
  std::unordered_map<uint64_t, uint32_t> vertices_;
};

}  // namespace

TriangleMesh generate_wall(const GeneratedScan& wanted) {
  const int side =
      lattice_size(std::sqrt(static_cast<double>(wanted.vertices) / kVerticesPerArea) + 1, 6);
  const Volume volume(side, wanted.seed);
  TriangleMesh mesh = Surface(volume).make();
  round_to_float(mesh);
  return mesh;
}

}  // namespace burnish
