#include "common/edit/brush.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/base/text_lines.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

static constexpr double kEndTolerance = 1e-6;  // of the spacing

// In the order of FallOff.
static constexpr std::string_view kFallOffs[] = {"smooth", "linear", "sharp", "constant"};

Result<FallOff> parse_fall_off(std::string_view word) {
  const auto found = std::ranges::find(kFallOffs, word);
  if (found != std::end(kFallOffs)) return static_cast<FallOff>(found - std::begin(kFallOffs));
  return invalid_argument("fall-off '" + std::string(word) +
                          "' is not smooth, linear, sharp or constant");
}

std::string_view name_of(FallOff fall_off) {
  return kFallOffs[static_cast<size_t>(fall_off)];
}

Status parse_painted(std::string_view word, Brush& brush) {
  brush.band = brush.curve = 0;
  brush.colour = word == "colour";
  brush.edges = word == "edges";
  brush.texture = word == "texture";
  if (word == "beta" || brush.colour || brush.edges || brush.texture) return Status::ok();
  const size_t colon = word.find(':');
  const std::string_view what = word.substr(0, colon);
  if (colon == std::string_view::npos || (what != "band" && what != "curve"))
    return invalid_argument(
        "'" + std::string(word) +
        "' is not what a brush paints: beta, colour, edges, texture, band:NUMBER or curve:NUMBER");
  ASSIGN_OR_RETURN((what == "band" ? brush.band : brush.curve),
                   parse_integer(word.substr(colon + 1)));
  if (brush.band != 0 || brush.curve != 0) return Status::ok();
  return invalid_argument("'" + std::string(word) + "': bands and curves are numbered from 1");
}

std::string painted_word(const Brush& brush) {
  if (brush.band > 0) return "band:" + std::to_string(brush.band);
  if (brush.curve > 0) return "curve:" + std::to_string(brush.curve);
  if (brush.edges) return "edges";
  if (brush.texture) return "texture";
  return brush.colour ? "colour" : "beta";
}

Status parse_brush_words(std::span<const std::string_view> words, Brush& brush) {
  brush.connected = true;
  std::string_view painted, reach;
  for (const std::string_view word : words) {
    std::string_view& same = word == "through" || word == "connected" ? reach : painted;
    if (!same.empty())
      return invalid_argument("the brush has '" + std::string(same) + "' and '" +
                              std::string(word) + "', it must be one of them");
    same = word;
  }
  if (!painted.empty()) RETURN_IF_ERROR(parse_painted(painted, brush));
  brush.connected = reach != "through";
  return Status::ok();
}

std::string brush_words(const Brush& brush) {
  std::string words;
  if (painted_word(brush) != "beta") words += " " + painted_word(brush);
  if (!brush.connected) words += " through";
  return words;
}

double fall_off_weight(FallOff fall_off, double distance_over_radius) {
  const double x = distance_over_radius;
  if (!(x < 1)) return 0;
  switch (fall_off) {
    case FallOff::kSmooth:
      return (1 - x) * (1 - x) * (1 + 2 * x);
    case FallOff::kLinear:
      return 1 - x;
    case FallOff::kSharp:
      return (1 - x) * (1 - x);
    case FallOff::kConstant:
      return 1;
  }
  return 0;
}

std::vector<Vec3d> dab_centres(const Stroke& stroke) {
  const double spacing = kDabSpacing * stroke.brush.radius;
  std::vector<Vec3d> centres = {stroke.path.front()};
  double until_next = spacing;
  for (size_t i = 1; i < stroke.path.size(); ++i) {
    const Vec3d a = stroke.path[i - 1];
    const Vec3d along = stroke.path[i] - a;
    const double length = along.norm();
    double at = until_next;
    for (; at <= length && centres.size() <= kStrokeDabsMax; at += spacing)
      centres.push_back(a + along * (at / length));
    until_next = at - length;
  }
  // A path of a whole number of spacings ends on a dab, however the sum was rounded.
  if (until_next <= kEndTolerance * spacing) centres.push_back(stroke.path.back());
  return centres;
}

static Status check_path(const std::vector<Vec3d>& path) {
  if (path.empty()) return invalid_argument("the stroke's path has no points");
  if (path.size() > kStrokeDabsMax)
    return invalid_argument("the stroke's path has " + std::to_string(path.size()) +
                            " points, the limit is " + std::to_string(kStrokeDabsMax));
  for (size_t i = 0; i < path.size(); ++i) {
    if ((path[i].array().abs() <= kCoordinateMagnitudeMax).all()) continue;
    return invalid_argument("point " + std::to_string(i + 1) +
                            " of the stroke's path must be finite and within ±1e18");
  }
  return Status::ok();
}

static Status check_painted(const Brush& brush) {
  const auto outside = [](const std::string& what, size_t most) {
    return invalid_argument("the brush paints " + what + ", the limit is 0 to " +
                            std::to_string(most));
  };
  if (brush.band < 0 || brush.band > static_cast<int>(kBandsMax))
    return outside("band " + std::to_string(brush.band), kBandsMax);
  if (brush.curve < 0 || brush.curve > static_cast<int>(kPaletteCurvesMax))
    return outside("curve " + std::to_string(brush.curve), kPaletteCurvesMax);
  if (brush.band > 0 && brush.curve > 0)
    return invalid_argument("the brush paints band " + std::to_string(brush.band) + " and curve " +
                            std::to_string(brush.curve) + ", it must be one of them");
  if ((brush.band > 0 || brush.curve > 0) + brush.colour + brush.edges + brush.texture > 1)
    return invalid_argument(
        "the brush paints two of colour, edges, texture, and a band or curve, it must be one of "
        "them");
  if (brush.edges && brush.beta > brush.value_max())
    return invalid_argument("the brush paints strength " + shortest_text(brush.beta) +
                            " of kept edges, the limit is 0 to 1");
  if (brush.texture && brush.beta > brush.value_max())
    return invalid_argument("the brush paints texture gain " + shortest_text(brush.beta) +
                            ", the limit is 0 to 4");
  return Status::ok();
}

Status validate(const Stroke& stroke) {
  const Brush& brush = stroke.brush;
  if (!(brush.radius > 0) || !(brush.radius <= kCoordinateMagnitudeMax))
    return invalid_argument("brush radius " + shortest_text(brush.radius) +
                            " must be above 0 and at most 1e18");
  if (!(brush.strength > 0 && brush.strength <= 1))
    return invalid_argument("brush strength " + shortest_text(brush.strength) +
                            " is outside (0, 1]");
  RETURN_IF_ERROR(check_beta(brush.beta).with_context("brush"));
  RETURN_IF_ERROR(check_painted(brush));
  RETURN_IF_ERROR(check_path(stroke.path));
  if (dab_centres(stroke).size() > kStrokeDabsMax)
    return invalid_argument("the stroke has more than " + std::to_string(kStrokeDabsMax) +
                            " dabs; use a larger radius or a shorter path");
  return Status::ok();
}

}  // namespace burnish
