#include "common/edit/palette.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/base/text_lines.h"

namespace burnish {
namespace {

constexpr uint32_t kColourMax = 0xFFFFFF;

Result<TransferCurve> parse_curve(std::string_view word) {
  if (word.find(':') != std::string_view::npos) return TransferCurve::parse(word);
  ASSIGN_OR_RETURN(const double alpha, parse_real(word));
  RETURN_IF_ERROR(check_alpha(alpha));
  return TransferCurve(alpha);
}

Result<uint32_t> parse_colour(std::string_view word) {
  const auto is_digit = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
  if (word.size() != 6 || !std::all_of(word.begin(), word.end(), is_digit))
    return invalid_argument("colour '" + std::string(word) + "' is not RRGGBB");
  return static_cast<uint32_t>(std::stoul(std::string(word), nullptr, 16));
}

Result<PaletteCurve> parse_line(const TextLine& line) {
  if (line.words.size() < 3) return invalid_argument("a curve's line must be: CURVE RRGGBB NAME");
  PaletteCurve curve;
  ASSIGN_OR_RETURN(curve.curve, parse_curve(line.words[0]));
  ASSIGN_OR_RETURN(curve.colour, parse_colour(line.words[1]));
  for (size_t i = 2; i < line.words.size(); ++i)
    curve.name += (i > 2 ? " " : "") + std::string(line.words[i]);
  return curve;
}

/// The least and the largest α of curves.
struct AlphaRange {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;

  void add(const TransferCurve& curve) {
    for (const TransferCurve::Point& point : curve.points()) {
      least = std::min(least, point.alpha);
      most = std::max(most, point.alpha);
    }
  }
  bool is_too_wide() const { return most > kCurveContrastMax * least; }
};

AlphaRange range_of(const Palette& palette) {
  AlphaRange range;
  for (const PaletteCurve& curve : palette.curves) range.add(curve.curve);
  return range;
}

std::string text_of(const AlphaRange& range) {
  char text[96];
  std::snprintf(text, sizeof text, "alpha from %g to %g, the limit is a factor of %g", range.least,
                range.most, kCurveContrastMax);
  return text;
}

/// Checks that a name comes back from a palette's text as it is.
Status check_name_in_text(const std::string& name) {
  RETURN_IF_ERROR(check_name("the curve's name", name));
  const bool has_odd_blanks =
      name.front() == ' ' || name.back() == ' ' || name.find("  ") != std::string::npos;
  if (!has_odd_blanks && name.find_first_of("#;") == std::string::npos) return Status::ok();
  return invalid_argument("the name '" + name +
                          "' must have no '#' or ';', and single blanks between words only");
}

Status check_curve(const Palette& palette, size_t index) {
  const PaletteCurve& curve = palette.curves[index];
  RETURN_IF_ERROR(check_name_in_text(curve.name));
  if (curve.colour > kColourMax)
    return invalid_argument("colour " + std::to_string(curve.colour) + " is above the limit " +
                            std::to_string(kColourMax));
  for (size_t before = 0; before < index; ++before)
    if (palette.curves[before].name == curve.name)
      return invalid_argument("the name '" + curve.name + "' is curve " +
                              std::to_string(before + 1) + "'s already");
  return Status::ok();
}

}  // namespace

Result<Palette> parse_palette(std::string_view text, const std::string& source) {
  Palette palette;
  for (const TextLine& line : split_lines(text)) {
    auto curve = parse_line(line);
    if (!curve.is_ok()) return curve.status().with_context(place(source, line));
    palette.curves.push_back(std::move(curve).value());
  }
  RETURN_IF_ERROR(check_palette(palette).with_context(source));
  return palette;
}

std::string to_text(const Palette& palette) {
  std::string text;
  for (const PaletteCurve& curve : palette.curves) {
    char colour[16];
    std::snprintf(colour, sizeof colour, " %06x ", curve.colour);
    text += curve.curve.to_string() + colour + curve.name + "\n";
  }
  return text;
}

Result<Palette> parse_palette_line(const std::string& line) {
  std::string text = line;
  std::replace(text.begin(), text.end(), ';', '\n');
  return parse_palette(text, "palette");
}

std::string to_line(const Palette& palette) {
  std::string line = to_text(palette);
  if (!line.empty()) line.pop_back();
  for (size_t end = line.find('\n'); end != std::string::npos; end = line.find('\n'))
    line.replace(end, 1, " ; ");
  return line;
}

std::string text_of(const Palette& palette) {
  const size_t count = palette.curves.size();
  return "palette of " + std::to_string(count) + (count == 1 ? " curve" : " curves");
}

Status check_palette(const Palette& palette) {
  if (palette.curves.size() > kPaletteCurvesMax)
    return invalid_argument("a palette of " + std::to_string(palette.curves.size()) +
                            " curves: the limit is " + std::to_string(kPaletteCurvesMax));
  for (size_t i = 0; i < palette.curves.size(); ++i)
    RETURN_IF_ERROR(check_curve(palette, i).with_context("curve " + std::to_string(i + 1)));
  const AlphaRange range = range_of(palette);
  if (range.is_too_wide())
    return invalid_argument("the curves of the palette have " + text_of(range));
  return Status::ok();
}

Status check_beside(const Palette& palette, const TransferCurve& curve) {
  AlphaRange range = range_of(palette);
  range.add(curve);
  if (!palette.curves.empty() && range.is_too_wide())
    return invalid_argument("the palette and the session's curve have " + text_of(range));
  return Status::ok();
}

}  // namespace burnish
