#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/base/types.h"
#include "common/edit/brush.h"
#include "common/pages/page_grid.h"

namespace burnish {

/// How far the weights of some vertices have come.
struct TintProgress {
  uint64_t stroke = 0;  ///< counts clear()
  size_t dabs = 0;
};

/// The trace of strokes that no frame shows yet, blended cell by cell as the server's brush will
/// blend it.
class StrokeTint {
 public:
  /// `depth` is the session's: the brush blends its cells.
  StrokeTint(const PageGrid& grid, int depth);

  void add_dab(const Brush& brush, const Vec3d& centre);
  void clear();
  bool is_clear() const { return dabs_.empty(); }

  /// Brings weights up to date, from 0 to 1; empty stands for all 0. Returns whether any has
  /// changed. Shapes: one weight per cell. Units: cells of the depth. Cost: the cells times the new
  /// dabs near them.
  bool update(std::span<const Vec3i> cells, TintProgress& progress,
              std::vector<float>& weights) const;

 private:
  struct Dab {
    Vec3f centre;  // cells
    float radius;  // cells
    float strength;
    FallOff fall_off;
  };
  static bool blend(const Dab& dab, std::span<const Vec3i> cells, std::span<float> weights);

  Vec3d origin_;
  double cell_size_;
  std::vector<Dab> dabs_;
  uint64_t stroke_ = 0;
};

}  // namespace burnish
