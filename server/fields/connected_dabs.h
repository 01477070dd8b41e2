#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/edit/brush.h"
#include "server/fields/surface_near.h"

namespace burnish {

/// Dabs of a connected brush. Each reaches the surface that hangs together with the place that it
/// touches. The dabs come one after the other, so the work can pause.
class ConnectedDabs {
 public:
  /// Needs: prepared outlives this; `cells` rising, with all that meet the ball of a dab.
  /// Shapes: at least one centre, file units.
  ConnectedDabs(const PreparedMesh& prepared, const Brush& brush, std::vector<Vec3d> centres,
                std::vector<int64_t> cells);

  /// Goes on for about so many cells of dabs. Returns whether all dabs are done. Pauses leave no
  /// trace in the result.
  bool advance(size_t cells);

  const std::vector<int64_t>& cells() const { return near_.cells(); }
  /// Returns the fraction of earlier paint that shows through the dabs. Shapes: one per cell.
  std::span<const double> left() const { return left_; }

 private:
  Brush brush_;
  std::vector<Vec3d> centres_;
  SurfaceNear near_;
  std::vector<double> left_;
  size_t next_ = 0;  // dab
  bool is_in_dab_ = false;
};

}  // namespace burnish
