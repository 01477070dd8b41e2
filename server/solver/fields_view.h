#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "common/edit/edit.h"

namespace burnish {

/// What β of a cell comes from: β = 1 + follow·(slider − 1) + own.
struct CellPaint {
  static constexpr size_t kStretch = 1024;
  std::span<const float> follow, own;   ///< of every cell: 1 and 0 without paint
  std::span<const uint8_t> is_painted;  ///< of each kStretch cells, whether any may have paint
};

/// α1, α2 and β of every cell of the finest depth. Units: α in user units.
struct FieldsView {
  std::span<const float> alpha1;
  std::span<const float> alpha2;
  std::span<const float> beta;
  double gradient_scale = kBetaDefault;  ///< the slider: β of every cell without paint of its own
  CellPaint paint;
};

}  // namespace burnish
