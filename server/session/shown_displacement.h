#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/edit/controls.h"
#include "common/grid/sparse_grid.h"
#include "server/fields/fields.h"
#include "server/prepare/prepared_mesh.h"
#include "server/session/keep_volume.h"
#include "server/session/rim_anchor.h"

namespace burnish {

/// Stands between the solver's displacement and all that is shown and exported: keeps the volume,
/// then the rims, the cap, and what is held. Without controls it hands the displacement through.
class ShownDisplacement {
 public:
  /// Needs: both outlive this.
  ShownDisplacement(const PreparedMesh& prepared, const SparseGrid& grid)
      : prepared_(prepared), grid_(grid) {}

  /// Returns whether of() can differ from the solver's displacement.
  static bool is_needed(const Controls& controls, const Fields& fields) {
    return fields.hold() || fields.rims() || controls.cap > 0 || controls.keep_volume;
  }

  /// Returns what is shown of `solved`, valid until the next call. An exact result measures the
  /// volume; others may take an older measure. Shapes: one per corner, in cells.
  std::span<const Vec3f> of(std::span<const Vec3f> solved, const Controls& controls,
                            const Fields& fields, bool is_exact);

  /// Returns the volume of what was shown when it was last measured, over the scan's; nothing
  /// unless it is to be kept.
  std::optional<double> kept_volume() const { return kept_volume_; }

  uint64_t byte_count() const {
    return shown_.size() * sizeof(Vec3f) + (volume_ ? volume_->byte_count() : 0) +
           (anchor_ ? anchor_->byte_count() : 0);
  }

 private:
  std::span<const Vec3f> keep_volume(std::span<const Vec3f> solved, const Controls& controls,
                                     const Fields& fields, bool is_exact);
  void bound(const Controls& controls, const Fields& fields);
  void anchor_rims(const Fields& fields);

  const PreparedMesh& prepared_;
  const SparseGrid& grid_;
  std::vector<Vec3f> shown_;
  std::optional<VolumeKeeper> volume_;  // made when it is wanted for the first time
  std::optional<double> kept_volume_;
  int uses_ = 0;                     // of the last measure
  std::optional<RimAnchor> anchor_;  // of the held rims
};

}  // namespace burnish
