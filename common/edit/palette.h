#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/limits.h"
#include "common/base/status.h"
#include "common/edit/transfer_curve.h"

namespace burnish {

/// A transfer curve that a brush can paint.
struct PaletteCurve {
  std::string name;
  uint32_t colour = 0x808080;  ///< 0xRRGGBB, sRGB
  TransferCurve curve{kAlphaDefault};
  bool operator==(const PaletteCurve&) const = default;
};

/// The curves that brushes paint, by number from 1. Elsewhere the session's own curve rules.
struct Palette {
  std::vector<PaletteCurve> curves;
  bool operator==(const Palette&) const = default;
};

/// Parses lines of "CURVE RRGGBB NAME", where CURVE is "K:A,K:A,..." or one α; '#' begins a
/// comment. Fails: invalid_argument that names the line of `source`, the value and the limit.
Result<Palette> parse_palette(std::string_view text, const std::string& source);

/// Returns text that parse_palette() reads back as the same palette.
std::string to_text(const Palette& palette);

/// The same in one line, for scripts: ';' in place of line ends.
Result<Palette> parse_palette_line(const std::string& line);
std::string to_line(const Palette& palette);

/// Describes it in a few words: "palette of 2 curves".
std::string text_of(const Palette& palette);

/// Fails: invalid_argument for more than kPaletteCurvesMax curves, a name that is empty, too long
/// or there twice, a colour above 0xFFFFFF, or curves whose α differ by more than
/// kCurveContrastMax. The message names the curve, the value and the limit.
Status check_palette(const Palette& palette);

/// Fails: invalid_argument if the α of the palette and of `curve` together differ by more than
/// kCurveContrastMax.
Status check_beside(const Palette& palette, const TransferCurve& curve);

}  // namespace burnish
