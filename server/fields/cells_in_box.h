#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// A box with sides along the axes. Units: file units.
struct AxisBox {
  Vec3d least, most;
  bool contains(const Vec3d& p) const {
    return (p.array() >= least.array()).all() && (p.array() <= most.array()).all();
  }
};

/// Returns the box of balls of one radius. Shapes: at least one centre.
AxisBox box_of(std::span<const Vec3d> centres, double radius);

/// Returns the cells of the finest depth in a box, and few others; rising. Without a search in the
/// Morton order a dab on a large scan would take as long as the scan is large.
std::vector<int64_t> cells_in(const AxisBox& box, const PreparedMesh& prepared);

}  // namespace burnish
