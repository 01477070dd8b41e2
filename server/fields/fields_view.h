#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/base/limits.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// Fields of a cell that follows neither curve nor slider.
struct OwnFields {
  int32_t cell;
  float alpha1, alpha2, beta;
};

/// What α1 and α2 of the finest depth's cells come from: alphas.h. Units: α in user units.
struct MetricView {
  const TransferCurve* curve;      ///< of κ1 and κ2 of each cell
  std::span<const OwnFields> own;  ///< of some cells, each once, by rising cell
  /// Whether all cells have one α.
  bool is_uniform() const { return own.empty() && curve->is_constant(); }
};

/// What β of a cell comes from: β = 1 + follow·(slider − 1) + own.
struct CellPaint {
  static constexpr size_t kStretch = 1024;
  std::span<const float> follow, own;   ///< of every cell: 1 and 0 without paint
  std::span<const uint8_t> is_painted;  ///< of each kStretch cells, whether any may have paint
};

/// The metric and β of every cell of the finest depth.
struct FieldsView {
  MetricView metric;
  std::span<const float> beta;
  double gradient_scale = kBetaDefault;  ///< the slider: β of every cell without paint of its own
  CellPaint paint;
};

}  // namespace burnish
