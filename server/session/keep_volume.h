#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Gives a closed surface the volume that it had. Every corner moves along the surface's normal
/// there, as far as its cells are edited: what no edit touches stays. Cheap to apply; measuring
/// visits the whole surface once.
class VolumeKeeper {
 public:
  /// Needs: a closed surface; both outlive this.
  VolumeKeeper(const PreparedMesh& prepared, const SparseGrid& grid);

  /// Finds out how far the corners must move for the volume of the scan. Shapes: one displacement
  /// per corner, in cells; per cell 0 to 1, how far it is edited.
  void measure(std::span<const Vec3f> displacement, std::span<const float> edited);

  /// Adds the offset that was measured last. Shapes: one per corner, in cells.
  void apply(std::span<Vec3f> displacement) const;

  uint64_t byte_count() const { return (normals_.size() + offsets_.size()) * sizeof(Vec3f); }

 private:
  void weigh(std::span<const float> edited);

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  std::vector<Vec3f> normals_;  // per corner; shorter than 1 where sheets face each other
  std::vector<Vec3f> offsets_;  // normals by how far the cells around are edited
  double distance_ = 0;         // cells per offset
};

}  // namespace burnish
