#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/limits.h"
#include "common/base/record.h"
#include "common/base/status.h"
#include "common/base/types.h"
#include "common/edit/texture_filter.h"

namespace burnish {

enum class FallOff { kSmooth, kLinear, kSharp, kConstant };

/// Parses "smooth", "linear", "sharp" or "constant". Fails: invalid_argument.
Result<FallOff> parse_fall_off(std::string_view word);
/// Returns the word that parse_fall_off() takes.
std::string_view name_of(FallOff fall_off);

/// The airbrush of section 6.1: a ball in the original geometry that blends its β into the cells.
/// It may instead paint the gain of a band, where a curve of the palette rules, the gradient scale
/// of the colours, the strength of kept edges, or the texture gain.
struct Brush {
  double radius = 0;    ///< file units, > 0
  double strength = 1;  ///< (0, 1]: the blend weight at the centre of one dab
  double beta = 0;      ///< the painted gradient scale; or the painted gain, or strength to 1
  FallOff fall_off = FallOff::kSmooth;
  int band = 0;          ///< of the equaliser, from 1; 0: paints no gain
  int curve = 0;         ///< of the palette, from 1; 0: paints no curve
  bool colour = false;   ///< paints the gradient scale of the colours
  bool edges = false;    ///< paints the strength of kept edges
  bool texture = false;  ///< paints the texture gain
  /// Each dab reaches only the surface that hangs together within its ball, from the place that it
  /// touches. Otherwise it paints through walls, as strokes of earlier versions do.
  bool connected = false;

  /// Returns the most that it paints, and what leaves the scan as it was.
  double value_max() const { return edges ? 1 : texture ? kTextureGainMax : kBetaMax; }
  double keeping_value() const { return edges ? 0 : 1; }
  /// Returns whether what it paints has limits of its own, other than those of β.
  bool has_own_limits() const { return edges || texture; }
  bool operator==(const Brush&) const = default;
};
BURNISH_RECORD(Brush, radius, strength, beta, connected)

/// Parses what a brush paints: "beta", "colour", "edges", "texture", "band:2" or "curve:1".
/// Fails: invalid_argument.
Status parse_painted(std::string_view word, Brush& brush);

/// Returns the word that parse_painted() takes.
std::string painted_word(const Brush& brush);

/// Parses the words behind a brush's fall-off: at most one as parse_painted() takes it, and at most
/// one of "connected" and "through", in any order. Without the latter the brush is connected.
/// Fails: invalid_argument that names the word.
Status parse_brush_words(std::span<const std::string_view> words, Brush& brush);

/// Returns the shortest words that parse_brush_words() takes, each after a space.
std::string brush_words(const Brush& brush);

/// A brush drag: the polyline of surface points, in file units, that the cursor passed. Its dabs
/// are a fraction of the radius apart, so the result does not depend on how often the cursor was
/// sampled.
struct Stroke {
  Brush brush;
  std::vector<Vec3d> path;  ///< at least one point
};

inline constexpr double kDabSpacing = 0.25;  // of the radius

/// Returns the weight in [0, 1] at `distance_over_radius` >= 0: 1 at the centre, 0 from the radius
/// on.
double fall_off_weight(FallOff fall_off, double distance_over_radius);

/// Returns the dab centres of a stroke: its first point, then one every kDabSpacing·radius.
std::vector<Vec3d> dab_centres(const Stroke& stroke);

/// Fails: invalid_argument for a non-finite or empty path, values outside their limits, or more
/// than kStrokeDabsMax dabs. The message names the field, its value and the limit.
Status validate(const Stroke& stroke);

}  // namespace burnish
