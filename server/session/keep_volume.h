#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Gives a closed surface the volume that it had. Every corner moves as far as its cells are
/// edited: what no edit touches stays. It moves along the scan's normal there; the more volume an
/// edit of the whole surface takes, the more it moves away from the centre of its piece instead,
/// because a collapsed surface does not fit the scan's normals. Cheap to apply; measuring visits
/// the whole surface twice.
class VolumeKeeper {
 public:
  /// Needs: a closed surface; both outlive this.
  VolumeKeeper(const PreparedMesh& prepared, const SparseGrid& grid);

  /// Finds out how far the corners must move for the volume of the scan. No vertex moves further
  /// than the box's diagonal, and nothing grows more than a hundredfold. Shapes: one displacement
  /// per corner, in cells; per cell 0 to 1, how far it is edited.
  void measure(std::span<const Vec3f> displacement, std::span<const float> edited);

  /// Returns what is shown of a surface whose corners move this far, if something bounds their
  /// moves.
  using Bounded = std::function<std::span<const Vec3f>(double distance)>;

  /// Finds the distance anew for a surface that is bounded, where one gives the volume back. Visits
  /// the whole surface about eight times. Needs: measure() of the surface that is not bounded.
  void measure_bounded(const Bounded& bounded, bool is_exact);

  /// Returns the distance that was measured last.
  double distance() const { return distance_; }

  /// Adds the offset of a distance. Shapes: one per corner, in cells.
  void apply(double distance, std::span<Vec3f> displacement) const;

  /// Returns the volume with the offset that was measured last, over the scan's.
  double kept() const { return kept_; }

  uint64_t byte_count() const {
    return (normals_.size() + centres_.size() + offsets_.size()) * sizeof(Vec3f);
  }

 private:
  void weigh(std::span<const Vec3f> displacement, std::span<const float> edited, double radial);

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  double scan_volume_;          // cells³
  std::vector<Vec3f> normals_;  // per corner; shorter than 1 where sheets face each other
  std::vector<Vec3f> centres_;  // per corner, of its piece of surface
  std::vector<Vec3f> offsets_;  // directions by how far the cells around are edited
  double distance_ = 0;         // cells per offset
  double distance_max_ = 0;     // of the box's diagonal, and of growth
  double kept_ = 1;
};

}  // namespace burnish
