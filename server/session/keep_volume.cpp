#include "server/session/keep_volume.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/evaluation/evaluation.h"
#include "server/session/corner_normals.h"

namespace burnish {
namespace {

constexpr size_t kChunk = 4096;  // triangles; sums by chunk do not depend on the threads
constexpr int kNewtonSteps = 20;
constexpr double kDistanceMax = 0.25;  // of the diagonal; more means that no distance helps

/// How the volume changes with the distance: c[0] + c[1] t + c[2] t² + c[3] t³, six times, grid
/// units.
using Cubic = std::array<double, 4>;

double value(const Cubic& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}
double slope(const Cubic& c, double t) {
  return c[1] + t * (2 * c[2] + t * 3 * c[3]);
}

double det(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return a.dot(b.cross(c));
}

/// A vertex of the scan, how edits move it, and the offset of one distance.
struct Moving {
  Vec3d scan, edited, offset;
};

void add(const std::array<Moving, 3>& m, Cubic& sum) {
  const Vec3d &a = m[0].edited, &b = m[1].edited, &c = m[2].edited;
  const Vec3d &u = m[0].offset, &v = m[1].offset, &w = m[2].offset;
  sum[0] += det(a, b, c) - det(m[0].scan, m[1].scan, m[2].scan);
  sum[1] += det(u, b, c) + det(a, v, c) + det(a, b, w);
  sum[2] += det(u, v, c) + det(u, b, w) + det(a, v, w);
  sum[3] += det(u, v, w);
}

/// Returns the zero nearest to 0, and 0 if there is none within `limit`.
double zero_of(const Cubic& c, double limit) {
  if (c[0] == 0) return 0;
  double t = 0;
  for (int step = 0; step < kNewtonSteps; ++step) {
    const double next = t - value(c, t) / slope(c, t);
    if (!(std::abs(next) <= limit)) return 0;
    if (next == t) break;
    t = next;
  }
  return t;
}

}  // namespace

VolumeKeeper::VolumeKeeper(const PreparedMesh& prepared, const SparseGrid& grid)
    : prepared_(prepared),
      grid_(grid),
      normals_(corner_normals(prepared, grid)),
      offsets_(normals_.size(), Vec3f::Zero()) {}

void VolumeKeeper::weigh(std::span<const float> edited) {
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < offsets_.size(); ++corner) {
    float sum = 0;
    int cells = 0;
    for (const int32_t cell : grid_.cells_of_corner[corner]) {
      if (cell == kNone) continue;
      sum += edited[cell];
      ++cells;
    }
    offsets_[corner] = normals_[corner] * (cells > 0 ? sum / float(cells) : 0.0f);
  }
}

void VolumeKeeper::measure(std::span<const Vec3f> displacement, std::span<const float> edited) {
  weigh(edited);
  const Vec3d centre =
      prepared_.frame.to_grid(prepared_.statistics.box_min / 2 + prepared_.statistics.box_max / 2);
  const auto moving = [&](uint32_t v) {
    const EvaluationPoint& point = prepared_.evaluation[v];
    const Vec3d scan = prepared_.frame.to_grid(prepared_.vertices[v]) - centre;
    const Vec3d moved = evaluate(grid_, point, displacement).cast<double>();
    return Moving{scan, scan + moved,
                  evaluate(grid_, point, std::span<const Vec3f>(offsets_)).cast<double>()};
  };
  const std::span<const Triangle> triangles = prepared_.triangles;
  std::vector<Cubic> sums((triangles.size() + kChunk - 1) / kChunk, Cubic{});
#pragma omp parallel for schedule(dynamic)
  for (size_t chunk = 0; chunk < sums.size(); ++chunk)
    for (size_t t = chunk * kChunk; t < std::min((chunk + 1) * kChunk, triangles.size()); ++t)
      add({moving(triangles[t][0]), moving(triangles[t][1]), moving(triangles[t][2])}, sums[chunk]);
  Cubic whole{};
  for (const Cubic& sum : sums)
    for (size_t i = 0; i < whole.size(); ++i) whole[i] += sum[i];
  distance_ =
      zero_of(whole, kDistanceMax * prepared_.statistics.diagonal() / prepared_.frame.cell_size);
}

void VolumeKeeper::apply(std::span<Vec3f> displacement) const {
  if (distance_ == 0) return;
  const auto distance = static_cast<float>(distance_);
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < displacement.size(); ++corner)
    displacement[corner] += distance * offsets_[corner];
}

}  // namespace burnish
