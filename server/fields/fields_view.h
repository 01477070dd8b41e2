#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "common/base/limits.h"
#include "common/edit/transfer_curve.h"
#include "common/grid/cell_corners.h"

namespace burnish {

/// Fields of a cell that follows neither the curve nor the slider.
struct OwnFields {
  int32_t cell;
  float alpha1, alpha2, beta;
};

/// ∫ B_a B_b along the held lines in a cell. Units: grid.
struct LineMass {
  int32_t cell;
  std::array<double, kPairsPerCell> pair = {};       ///< a < b: (0,1) ... (0,7), (1,2) ...
  std::array<double, kCornersPerCell> row_sum = {};  ///< ∫ B_a
};

/// The lines that are held, each with a stiffness far above that of its cell.
struct LineView {
  static constexpr size_t kStretch = 1024;
  std::span<const LineMass> lines;  ///< by rising cell
  std::span<const int32_t> first;   ///< into `lines`: see first_lines(); empty without lines

  /// Returns null if no line passes the cell.
  const LineMass* find(int32_t cell) const {
    if (lines.empty()) return nullptr;
    const size_t stretch = cell / kStretch;
    const auto of = lines.subspan(first[stretch], first[stretch + 1] - first[stretch]);
    const auto found = std::ranges::lower_bound(of, cell, {}, &LineMass::cell);
    return found == of.end() || found->cell != cell ? nullptr : &*found;
  }
};

/// The sources of α1 and α2 of the finest depth's cells: see alphas.h. Units: α in user units.
struct MetricView {
  const TransferCurve* curve;      ///< of κ1 and κ2 of each cell
  std::span<const OwnFields> own;  ///< some cells, each once, by rising cell
  LineView held = {};
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

/// Two 3×3 matrices of a cell that turn the gradient of the surface into the one that it should
/// have: see TargetView. Rows lie one after the other.
struct TargetGradient {
  std::array<float, 9> of_scale;   ///< T1
  std::array<float, 9> of_target;  ///< T2
};

/// The gradient that the surface should have in place of its own. With g the constraint of a cell
/// at β − 1 = 1, its share is (β−1)(I + s T1) g + s T2 g, s the strength in the cell. At s = 0 that
/// is the plain one.
struct TargetView {
  std::span<const TargetGradient> cells;  ///< empty: there is no target
  double strength = 0;                    ///< 0 to 1
  uint64_t version = 0;                   ///< other `cells` have another one
  std::span<const float> part = {};       ///< of the strength, per cell; empty: 1 in all
  uint64_t part_version = 0;              ///< another `part` has another one

  bool is_active() const { return !cells.empty() && strength != 0; }
  double strength_in(size_t cell) const { return part.empty() ? strength : strength * part[cell]; }
  bool is_same(const TargetView& other) const {
    return is_active() == other.is_active() &&
           (!is_active() || (strength == other.strength && version == other.version &&
                             part_version == other.part_version));
  }
};

/// The metric and β of every cell of the finest depth.
struct FieldsView {
  MetricView metric;
  std::span<const float> beta;
  double gradient_scale = kBetaDefault;  ///< the slider: β of every cell without its own paint
  CellPaint paint;
  TargetView target = {};
};

}  // namespace burnish
