#include "server/session/rim_anchor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/sort_once.h"
#include "common/evaluation/evaluation.h"
#include "server/fields/cell_layers.h"

namespace burnish {
namespace {

constexpr int kReachCells = 4;      // nothing is taken back farther from a rim
constexpr double kWholeWithin = 2;  // cells: all corners of a rim's cells
constexpr double kBeside = 0.75;    // cells: vertices so little beyond the nearest one count too

/// The vertices of the rims, in cubes as wide as the reach.
class RimPlaces {
 public:
  RimPlaces(const PreparedMesh& prepared, std::span<const uint32_t> vertices) {
    for (size_t i = 0; i < vertices.size(); ++i)
      points_.push_back(prepared.frame.to_grid(prepared.vertices[vertices[i]]));
    for (size_t i = 0; i < points_.size(); ++i)
      order_.emplace_back(cube_of(points_[i]), static_cast<uint32_t>(i));
    std::ranges::sort(order_);
  }

  /// Calls visit(vertex, distance) for those around a point, within the reach and some beyond it.
  template <typename Visit>
  void for_each_near(const Vec3d& at, const Visit& visit) const {
    const Vec3i home = (at / kReachCells).array().floor().cast<int>();
    for (int i = 0; i < 27; ++i) {
      const Vec3i cube = home + Vec3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (cube.minCoeff() < 0) continue;
      const MortonKey key = morton_key(cube);
      for (auto there = std::ranges::lower_bound(order_, std::pair(key, uint32_t{0}));
           there != order_.end() && there->first == key; ++there)
        visit(there->second, (points_[there->second] - at).norm());
    }
  }

 private:
  static MortonKey cube_of(const Vec3d& at) {
    return morton_key((at / kReachCells).array().floor().cast<int>());
  }

  std::vector<Vec3d> points_;  // grid units
  std::vector<std::pair<MortonKey, uint32_t>> order_;
};

// Returns how much is taken back at a distance from the rim: 1 near it, 0 at the reach.
double part_at(double distance) {
  const double beyond =
      std::clamp((distance - kWholeWithin) / (kReachCells - kWholeWithin), 0.0, 1.0);
  return 1 - beyond * beyond * (3 - 2 * beyond);
}

std::vector<int32_t> corners_of(const SparseGrid& grid, std::span<const uint8_t> layer) {
  std::vector<int32_t> corners;
  for (size_t cell = 0; cell < layer.size(); ++cell)
    if (layer[cell] <= kReachCells)
      corners.insert(corners.end(), grid.cell_corners[cell].begin(), grid.cell_corners[cell].end());
  sort_once(corners);
  return corners;
}

}  // namespace

RimAnchor::RimAnchor(const PreparedMesh& prepared, const SparseGrid& grid,
                     std::shared_ptr<const HeldRims> rims)
    : prepared_(prepared), grid_(grid), rims_(std::move(rims)), moved_(rims_->places.size()) {
  find_corners(prepared);
}

// A corner follows the mean of its nearest vertices of rims.
void RimAnchor::find_corners(const PreparedMesh& prepared) {
  std::vector<int32_t> cells;
  for (const LineMass& line : rims_->lines) cells.push_back(line.cell);
  const RimPlaces places(prepared, rims_->places);
  std::vector<Share> near;
  for (const int32_t corner : corners_of(grid_, layers_from(prepared, cells, kReachCells))) {
    const Vec3d at = morton_point(grid_.corners[corner].place).cast<double>();
    double nearest = kReachCells;
    places.for_each_near(at, [&](uint32_t, double d) { nearest = std::min(nearest, d); });
    if (nearest >= kReachCells) continue;
    near.clear();
    double sum = 0;
    places.for_each_near(at, [&](uint32_t vertex, double d) {
      const double weight = 1 - (d - nearest) / kBeside;
      if (weight <= 0) return;
      near.push_back({vertex, static_cast<float>(weight)});
      sum += weight;
    });
    for (Share& share : near) share.weight *= static_cast<float>(part_at(nearest) / sum);
    corners_.push_back(corner);
    shares_.add(near);
  }
}

void RimAnchor::apply(std::span<Vec3f> displacement) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < moved_.size(); ++i)
    moved_[i] = evaluate<Vec3f>(grid_, prepared_.evaluation[rims_->places[i]], displacement);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < corners_.size(); ++i)
    for (const Share& share : shares_[i])
      displacement[corners_[i]] -= share.weight * moved_[share.vertex];
}

uint64_t RimAnchor::byte_count() const {
  return corners_.capacity() * sizeof(int32_t) + shares_.byte_count() +
         moved_.capacity() * sizeof(Vec3f);
}

}  // namespace burnish
