#include "server/session/keep_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "common/evaluation/evaluation.h"
#include "common/grid/morton.h"
#include "server/session/corner_normals.h"
#include "server/session/volume_root.h"

namespace burnish {
namespace {

constexpr size_t kChunk = 4096;          // triangles; sums by chunk do not depend on the threads
constexpr double kGrowthMax = 100;       // rounding and the solver's error grow with the surface
constexpr int kStepsOfFrame = 12;        // a picture that moves waits for no more
constexpr double kReachOfNormal = 0.25;  // of the diagonal; an offset along normals, to one radius

double det(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return a.dot(b.cross(c));
}

Vec3d middle_of(const PreparedMesh& prepared) {
  return prepared.frame.to_grid(prepared.statistics.box_min / 2 + prepared.statistics.box_max / 2);
}

using Vec4d = Eigen::Vector4d;  // a sum of places by area, and the area

/// Returns for each corner of the finest depth the centre of its piece of surface: the mean of the
/// piece's cells by area. Cells that share a corner are of one piece. Units: cells.
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

/// Adds up a sum of each triangle. `of` takes a triangle and a sum of such a type.
template <typename Sum, typename Of>
Sum sum_triangles(std::span<const Triangle> triangles, const Of& of) {
  std::vector<Sum> sums((triangles.size() + kChunk - 1) / kChunk);
#pragma omp parallel for schedule(dynamic)
  for (size_t chunk = 0; chunk < sums.size(); ++chunk)
    for (size_t t = chunk * kChunk; t < std::min((chunk + 1) * kChunk, triangles.size()); ++t)
      of(triangles[t], sums[chunk]);
  Sum whole;
  for (const Sum& sum : sums) whole += sum;
  return whole;
}

/// Six times a volume.
struct Volume {
  double six = 0;
  Volume& operator+=(const Volume& other) {
    six += other.six;
    return *this;
  }
};

double volume_of(const PreparedMesh& prepared, const SparseGrid& grid,
                 std::span<const Vec3f> displacement) {
  const Vec3d middle = middle_of(prepared);
  const auto place = [&](uint32_t v) -> Vec3d {
    const Vec3d moved = evaluate(grid, prepared.evaluation[v], displacement).cast<double>();
    return prepared.frame.to_grid(prepared.vertices[v]) - middle + moved;
  };
  const auto add = [&](const Triangle& t, Volume& sum) {
    sum.six += det(place(t[0]), place(t[1]), place(t[2]));
  };
  return sum_triangles<Volume>(prepared.triangles, add).six / 6;
}

/// How edits move a vertex, and the offset of one distance.
struct Moving {
  Vec3d edited, offset;
};

/// How the volume grows with the distance, six times, and how far the farthest vertex moves.
struct Growth {
  Cubic cubic = {};
  double reach = 0;

  void add(const std::array<Moving, 3>& m) {
    const Vec3d &a = m[0].edited, &b = m[1].edited, &c = m[2].edited;
    const Vec3d &u = m[0].offset, &v = m[1].offset, &w = m[2].offset;
    cubic[0] += det(a, b, c);
    cubic[1] += det(u, b, c) + det(a, v, c) + det(a, b, w);
    cubic[2] += det(u, v, c) + det(u, b, w) + det(a, v, w);
    cubic[3] += det(u, v, w);
    reach = std::max({reach, u.squaredNorm(), v.squaredNorm(), w.squaredNorm()});
  }
  Growth& operator+=(const Growth& other) {
    for (size_t i = 0; i < cubic.size(); ++i) cubic[i] += other.cubic[i];
    reach = std::max(reach, other.reach);
    return *this;
  }
};

/// Returns how much an edit concerns the whole surface: 1 if it is the same everywhere, and the
/// part of the cells that it touches if the others stay.
double coverage_of(std::span<const float> edited) {
  double sum = 0, squares = 0;
  for (const float weight : edited) {
    sum += weight;
    squares += double{weight} * weight;
  }
  return squares > 0 ? sum * sum / (squares * double(edited.size())) : 0;
}

}  // namespace

VolumeKeeper::VolumeKeeper(const PreparedMesh& prepared, const SparseGrid& grid)
    : prepared_(prepared),
      grid_(grid),
      normals_(corner_normals(prepared, grid)),
      centres_(piece_centres(prepared, grid)),
      offsets_(normals_.size(), Vec3f::Zero()) {
  scan_volume_ = volume_of(prepared, grid, offsets_);
}

// All is continuous in the edit: a slider never makes the surface jump.
void VolumeKeeper::weigh(std::span<const Vec3f> displacement, std::span<const float> edited,
                         double radial) {
  const double cells = prepared_.statistics.diagonal() / prepared_.frame.cell_size;
  const double outwards = std::copysign(kReachOfNormal, scan_volume_);  // it may be inside out
  const auto by_normal = static_cast<float>((1 - radial) * outwards * cells);
  const auto by_place = static_cast<float>(radial);
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < offsets_.size(); ++corner) {
    float sum = 0;
    int count = 0;
    for (const int32_t cell : grid_.cells_of_corner[corner]) {
      if (cell == kNone) continue;
      sum += edited[cell];
      ++count;
    }
    const Vec3f place = morton_point(grid_.corners[corner].place).cast<float>();
    const Vec3f from_centre = place + displacement[corner] - centres_[corner];
    const float weight = count > 0 ? sum / float(count) : 0.0f;
    offsets_[corner] = weight * (by_normal * normals_[corner] + by_place * from_centre);
  }
}

void VolumeKeeper::measure(std::span<const Vec3f> displacement, std::span<const float> edited) {
  if (scan_volume_ == 0) return;
  const double left = volume_of(prepared_, grid_, displacement) / scan_volume_;
  const double radial = coverage_of(edited) * std::clamp(1 - left * left, 0.0, 1.0);
  weigh(displacement, edited, radial);
  const Vec3d middle = middle_of(prepared_);
  const auto moving = [&](uint32_t v) {
    const EvaluationPoint& point = prepared_.evaluation[v];
    const Vec3d scan = prepared_.frame.to_grid(prepared_.vertices[v]) - middle;
    return Moving{scan + evaluate(grid_, point, displacement).cast<double>(),
                  evaluate(grid_, point, std::span<const Vec3f>(offsets_)).cast<double>()};
  };
  const auto add = [&](const Triangle& t, Growth& sum) {
    sum.add({moving(t[0]), moving(t[1]), moving(t[2])});
  };
  const Growth growth = sum_triangles<Growth>(prepared_.triangles, add);
  Cubic missing = growth.cubic;  // negative while there is too little
  missing[0] -= 6 * scan_volume_;
  if (scan_volume_ < 0)
    for (double& c : missing) c = -c;
  const double diagonal = prepared_.statistics.diagonal() / prepared_.frame.cell_size;
  const double farthest = growth.reach > 0 ? diagonal / std::sqrt(growth.reach) : 0;
  distance_max_ = radial > 0 ? std::min(farthest, kGrowthMax / radial) : farthest;
  distance_ = first_zero(missing, distance_max_);
  kept_ = value_at(growth.cubic, distance_) / (6 * scan_volume_);
}

// A cap takes from parts that move far, and the offset of the whole surface would be too large.
void VolumeKeeper::measure_bounded(const Bounded& bounded, bool is_exact) {
  if (scan_volume_ == 0) return;
  const auto excess = [&](double distance) {
    return volume_of(prepared_, grid_, bounded(distance)) / scan_volume_ - 1;
  };
  ZeroSearch search = {.guess = distance_, .limit = distance_max_, .tolerance = 1e-8};
  if (!is_exact) search.steps_max = kStepsOfFrame;
  distance_ = curve_zero(excess, search);
  kept_ = 1 + excess(distance_);
}

void VolumeKeeper::apply(double distance, std::span<Vec3f> displacement) const {
  if (distance == 0) return;
  const auto step = static_cast<float>(distance);
#pragma omp parallel for schedule(static)
  for (size_t corner = 0; corner < displacement.size(); ++corner)
    displacement[corner] += step * offsets_[corner];
}

}  // namespace burnish
