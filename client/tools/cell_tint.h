#pragma once

#include <span>
#include <vector>

#include "common/edit/brush.h"
#include "common/view/view.h"

namespace burnish {

/// Elements first..first+count of an array.
struct IndexRange {
  size_t first = 0;
  size_t count = 0;
};

/// The trace of a stroke, cell by cell, blended as the server's brush will blend it. It is shown
/// before any answer comes.
class CellTint {
 public:
  explicit CellTint(const View& view);

  /// Blends one dab and returns the cells that may have changed. Cost: the cells in its box.
  IndexRange add_dab(const Brush& brush, const Vec3d& centre);

  /// Sets everything to zero. Returns the cells that may have changed.
  IndexRange clear();

  std::span<const float> weights() const { return weights_; }
  bool is_clear() const { return touched_.count == 0; }

 private:
  struct Block {
    Eigen::AlignedBox3f box;
    IndexRange cells;
  };
  IndexRange blend(const Block& block, const Brush& brush, const Vec3f& centre, float radius);

  GridFrame frame_;
  std::vector<Vec3f> centres_;  // of cells, grid units
  std::vector<Block> blocks_;   // cells are in Morton order: neighbours in the array are near
  std::vector<float> weights_;
  IndexRange touched_;
};

/// Returns the smallest range that holds both.
IndexRange united(const IndexRange& a, const IndexRange& b);

}  // namespace burnish
