#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/grid/sparse_grid.h"
#include "server/fields/fields.h"
#include "server/session/band_surfaces.h"

namespace burnish {

/// Adds the bands of an equaliser, each with its gain, to a solver's displacement. With u_k the
/// surface behind band k of n, and gains g_k, this adds Σ (g_{k+1} − g_k) u_k, where g_{n+1} = 1.
/// So gains of 1 add exactly nothing, and a gain costs no solve.
class BandMix {
 public:
  /// Needs: `grid` outlives this.
  explicit BandMix(const SparseGrid& grid) : grid_(grid) {}

  /// Returns the sum, valid until the next call; `solved` itself if there is nothing to add. Bands
  /// whose surface is missing have gain 1. Shapes: one per corner. Units: cells.
  std::span<const Vec3f> of(std::span<const Vec3f> solved, const Fields& fields,
                            const BandSurfaces& surfaces);

  uint64_t byte_count() const;

 private:
  /// A band's gain is its slider times `follow`, plus `own`. Shapes: one per corner; empty without
  /// paint.
  struct PaintedGain {
    std::vector<float> follow, own;
  };

  void update_paint(const Fields& fields);
  PaintedGain gain_of(const PaintLayer& layer) const;

  const SparseGrid& grid_;
  std::array<PaintedGain, kBandsMax> painted_;
  uint64_t painted_version_ = 0;  // of the fields' paint
  std::vector<Vec3f> sum_;
};

}  // namespace burnish
