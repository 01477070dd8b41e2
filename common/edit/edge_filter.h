#pragma once

#include <span>
#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

inline constexpr double kEdgeAngleMin = 5;  // degrees
inline constexpr double kEdgeAngleMax = 120;
inline constexpr int kNormalPassesMax = 100;
inline constexpr double kEdgeWaveEdges = 12;  // mean edges of the mesh

/// How normals are filtered.
enum class NormalFilterKind {
  kBilateral,  ///< a triangle's own normal says which neighbours are of its side of an edge
  kEdges,      ///< the most even ring around says it: for machined parts
};

/// Leads the surface to filtered normals, which keep edges, before it is smoothed or sharpened:
/// noise goes and is not sharpened. Off at strength 0.
struct EdgeFilter {
  double strength = 0;  ///< 0 to 1
  NormalFilterKind kind = NormalFilterKind::kBilateral;
  double edge_angle = 35;  ///< degrees; sharper bends are edges
  /// The filter's passes. Noise of up to about an edge's length times their root goes.
  int passes = 20;
  double crispness = 1;  ///< 0 to 1: low for relief, high for machined parts
  bool operator==(const EdgeFilter&) const = default;

  bool is_on() const { return strength > 0; }
  /// Returns half the difference of two unit normals at the edge angle: the filter's σ.
  double sigma() const;
};

/// A filter for a kind of scan, at full strength.
struct EdgePreset {
  std::string_view name;   ///< a word
  std::string_view title;  ///< for panels
  std::string_view scans;  ///< what it is for
  EdgeFilter filter;
};

/// "machined", "scanner", "soft", "relief". Each goes with the α of a wave of kEdgeWaveEdges.
std::span<const EdgePreset> edge_presets();
/// Fails: invalid_argument that names the words.
Result<EdgePreset> find_edge_preset(std::string_view name);

/// Returns the preset with this filter at any strength; null if there is none.
const EdgePreset* preset_of(const EdgeFilter& filter);

/// Returns the size of noise that so many passes take away, and the other way round. Units: file
/// units.
double noise_size(int passes, double mean_edge);
int passes_of_noise_size(double size, double mean_edge);

/// Returns "bilateral" or "edges".
std::string_view name_of(NormalFilterKind kind);
/// Fails: invalid_argument that names the words.
Result<NormalFilterKind> parse_normal_filter(std::string_view word);

/// Describes it in a few words: "edges kept at strength 1, angle 35, 20 passes, crispness 1".
std::string text_of(const EdgeFilter& filter);

/// Fails: invalid_argument that names the value and its limits.
Status check_edge_filter(const EdgeFilter& filter);

}  // namespace burnish
