#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "common/base/limits.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// Fields of a cell that follows neither the curve nor the slider.
struct OwnFields {
  int32_t cell;
  float alpha1, alpha2, beta;
};

/// The sources of α1 and α2 of the finest depth's cells: see alphas.h. Units: α in user units.
struct MetricView {
  const TransferCurve* curve;      ///< of κ1 and κ2 of each cell
  std::span<const OwnFields> own;  ///< some cells, each once, by rising cell
  /// Returns whether all cells have one α.
  bool is_uniform() const { return own.empty() && curve->is_constant(); }
  /// Returns whether α1 = α2 in each cell.
  bool is_isotropic() const {
    return curve->is_constant() &&
           std::ranges::all_of(own, [](const OwnFields& of) { return of.alpha1 == of.alpha2; });
  }
};

/// The sources of a cell's β: β = 1 + follow·(slider − 1) + own.
struct CellPaint {
  static constexpr size_t kStretch = 1024;
  std::span<const float> follow, own;   ///< per cell: 1 and 0 without paint
  std::span<const uint8_t> is_painted;  ///< per kStretch cells: one of them may have paint
};

/// The metric and β of every cell of the finest depth.
struct FieldsView {
  MetricView metric;
  std::span<const float> beta;
  double gradient_scale = kBetaDefault;  ///< the slider: β of every cell without its own paint
  CellPaint paint;
};

}  // namespace burnish
