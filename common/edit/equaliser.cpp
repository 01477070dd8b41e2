#include "common/edit/equaliser.h"

#include <algorithm>
#include <cstdio>

#include "common/base/fixed_text.h"
#include "common/base/limits.h"
#include "common/base/text_lines.h"

namespace burnish {

double response(const Equaliser& equaliser, double wavelength) {
  double before = 1, sum = 0;
  for (const Band& band : equaliser.bands) {
    const double ratio = band.size / wavelength, behind = 1 / (1 + ratio * ratio);
    sum += band.gain * (before - behind);
    before = behind;
  }
  return sum + before;
}

Result<Band> parse_band(std::string_view text) {
  const size_t colon = text.find(':');
  if (colon == std::string_view::npos)
    return invalid_argument("band '" + std::string(text) + "' is not SIZE:GAIN");
  Band band;
  ASSIGN_OR_RETURN(band.size, parse_real(text.substr(0, colon)));
  ASSIGN_OR_RETURN(band.gain, parse_real(text.substr(colon + 1)));
  return band;
}

std::string text_of(const Equaliser& equaliser) {
  if (equaliser.bands.empty()) return "no bands";
  std::string text = equaliser.bands.size() == 1 ? "band" : "bands";
  constexpr int kDigits = 3;
  for (const Band& band : equaliser.bands)
    text += " " + fixed_text(band.size, kDigits) + ":" + fixed_text(band.gain, kDigits);
  return text;
}

static Status check_band(const Band& band) {
  char text[96];
  if (!(band.size > 0 && band.size <= kCoordinateMagnitudeMax)) {
    std::snprintf(text, sizeof text, "size %g must be above 0 and at most %g", band.size,
                  kCoordinateMagnitudeMax);
    return invalid_argument(text);
  }
  if (band.gain >= kGainMin && band.gain <= kGainMax) return Status::ok();
  std::snprintf(text, sizeof text, "gain %g is outside %g to %g", band.gain, kGainMin, kGainMax);
  return invalid_argument(text);
}

Status check_equaliser(const Equaliser& equaliser) {
  const std::vector<Band>& bands = equaliser.bands;
  if (bands.size() > kBandsMax)
    return invalid_argument("an equaliser of " + std::to_string(bands.size()) +
                            " bands: the limit is " + std::to_string(kBandsMax));
  for (size_t i = 0; i < bands.size(); ++i) {
    const std::string where = "band " + std::to_string(i + 1);
    RETURN_IF_ERROR(check_band(bands[i]).with_context(where));
    if (i == 0 || bands[i].size >= kBandRatioMin * bands[i - 1].size) continue;
    char text[120];
    std::snprintf(text, sizeof text,
                  ": size %g must be at least %g times the size %g of the band before",
                  bands[i].size, kBandRatioMin, bands[i - 1].size);
    return invalid_argument(where + text);
  }
  return Status::ok();
}

}  // namespace burnish
