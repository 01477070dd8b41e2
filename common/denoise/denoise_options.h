#pragma once

#include <limits>
#include <span>
#include <string_view>

#include "common/base/status.h"
#include "common/edit/edge_filter.h"

namespace burnish {

inline constexpr double kSigmaMin = 0.04;  ///< of DenoiseOptions
inline constexpr double kSigmaMax = 1.5;
inline constexpr double kCrispnessMax = 1;

/// The options of a denoising that keeps edges.
struct DenoiseOptions {
  NormalFilterKind kind = NormalFilterKind::kBilateral;
  /// Differences of unit normals above about twice this are edges.
  double sigma = 0.3;
  /// Passes of the filter. Noise of up to about an edge's length times their root goes.
  int passes = 20;
  /// How much of the layer is used, 0 to 1: low for relief, high for machined parts.
  double crispness = 1;
  /// The layer moves no vertex further, file units.
  double cap = std::numeric_limits<double>::infinity();

  bool operator==(const DenoiseOptions&) const = default;
};

/// Fails: invalid_argument that names the value and its limits.
Status validate(const DenoiseOptions& options);

/// Returns what an edit asks for, without its strength.
DenoiseOptions options_of(const EdgeFilter& filter);

struct DenoisePreset {
  std::string_view name;
  DenoiseOptions options;
};

/// Returns the options of edge_presets(), in their order.
std::span<const DenoisePreset> denoise_presets();

}  // namespace burnish
