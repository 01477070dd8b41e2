#pragma once

#include <limits>
#include <span>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

inline constexpr double kEdgeAngleMin = 0.05;  ///< of DenoiseOptions::sigma
inline constexpr double kEdgeAngleMax = 1.5;
inline constexpr int kFilterPassesMax = 100;
inline constexpr double kCrispnessMax = 1;

/// How normals are filtered.
enum class NormalFilterKind {
  kBilateral,  ///< a triangle's own normal says which neighbours are of its side of an edge
  kEdges,      ///< the most even ring around says it: for machined parts
};

/// What a denoising that keeps edges does.
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

/// Returns the kind of this word: bilateral or edges. Fails: invalid_argument.
Result<NormalFilterKind> parse_normal_filter(std::string_view word);
std::string_view name_of(NormalFilterKind kind);

struct DenoisePreset {
  std::string_view name;
  DenoiseOptions options;
};

/// Machined part; Scanner noise, keep edges; Soft surface; Relief and inscriptions.
std::span<const DenoisePreset> denoise_presets();

}  // namespace burnish
