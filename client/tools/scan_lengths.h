#pragma once

#include <optional>
#include <span>

#include "common/edit/proposed_edges.h"

namespace burnish {

/// The measures of a scan that presets depend on. Units: of its file.
struct ScanLengths {
  double length_unit = 1;  ///< L
  double cell_size = 1;
  double mean_edge = 0;   ///< 0: unknown; only kept edges depend on it
  double sharp_bend = 0;  ///< as sharp_bend_of() has it; 0: unknown
  /// The noise, and how it asks to keep edges; nothing: it was not measured.
  std::optional<EdgeProposal> noise = {};
  bool can_keep_edges = true;  ///< not beside bands or a kept volume
};

/// Returns the magnitude of curvature, times L, that a tenth of the surface exceeds: ears, tails
/// and letters bend so. Cells average it, so it hardly depends on noise. `area`: fractions in bins
/// that are even in asinh from -range to range. 0 without bins.
double sharp_bend_of(float range, std::span<const float> area);

}  // namespace burnish
