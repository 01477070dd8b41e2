#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "common/base/groups.h"
#include "common/base/types.h"

namespace burnish {

using Box3d = Eigen::AlignedBox3d;

/// Private to this folder: triangles by the cells of a grid, so that a chart finds those near it
/// without a look at all of them.
class TriangleBoxes {
 public:
  explicit TriangleBoxes(std::span<const std::array<Vec3d, 3>> triangles);

  /// Returns the triangles whose boxes may meet this one, rising.
  std::vector<uint32_t> near(const Box3d& box) const;

 private:
  using Cell = std::array<int, 3>;

  Cell cell_of(const Vec3d& place) const;
  template <typename Visit>
  void for_each_cell(const Box3d& box, const Visit& visit) const;

  Box3d all_;
  Cell cells_ = {1, 1, 1};
  Groups<uint32_t, uint32_t> triangles_;  // by cell
};

}  // namespace burnish
