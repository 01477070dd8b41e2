#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/base/groups.h"
#include "common/base/types.h"
#include "common/grid/sparse_grid.h"
#include "server/fields/rims.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// Takes back what a displacement moves of the held rims, and less and less of it over the next
/// cells: the solver holds their lines by a stiffness that the cycle can still resolve, so they
/// give way by some tenths of a cell.
class RimAnchor {
 public:
  /// Needs: prepared and grid outlive this. Cost: linear in the rims' length.
  RimAnchor(const PreparedMesh& prepared, const SparseGrid& grid,
            std::shared_ptr<const HeldRims> rims);

  const std::shared_ptr<const HeldRims>& rims() const { return rims_; }

  /// Shapes: one per corner. Units: cells.
  void apply(std::span<Vec3f> displacement);

  uint64_t byte_count() const;

 private:
  struct Share {
    uint32_t vertex;  // of the rims' places
    float weight;
  };
  void find_corners(const PreparedMesh& prepared);

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  std::shared_ptr<const HeldRims> rims_;
  std::vector<int32_t> corners_;   // those that something is taken from
  Groups<Share, int64_t> shares_;  // of each of these
  std::vector<Vec3f> moved_;       // room: the move of each vertex of the rims
};

}  // namespace burnish
