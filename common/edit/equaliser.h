#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/base/record.h"
#include "common/base/status.h"

namespace burnish {

/// Details of one range of sizes.
struct Band {
  double size = 0;  ///< wavelength at which the band ends, file units, > 0
  double gain = 1;  ///< 0 removes its details, 1 keeps them
  bool operator==(const Band&) const = default;
};
BURNISH_RECORD(Band, size, gain)

/// Gains by the size of details. A band holds the details between the size of the band before and
/// its own; longer ones than the last size stay. Without bands nothing changes.
struct Equaliser {
  std::vector<Band> bands;  ///< from fine to coarse: sizes rise
  bool operator==(const Equaliser&) const = default;

  /// Returns the gain of a band. Shapes: `number` from 1; 1 beyond the last.
  double gain(size_t number) const { return number <= bands.size() ? bands[number - 1].gain : 1; }
};

/// Returns by how much the equaliser multiplies a wave on the surface. Behind a band of size s the
/// fraction 1 / (1 + (s / wavelength)²) is left. Units: as the sizes.
double response(const Equaliser& equaliser, double wavelength);

/// Parses "SIZE:GAIN". Fails: invalid_argument.
Result<Band> parse_band(std::string_view text);

/// Describes it in a few words: "bands 0.2:1.5 0.8:1", "no bands".
std::string text_of(const Equaliser& equaliser);

/// Fails: invalid_argument for more than kBandsMax bands, a size outside (0,
/// kCoordinateMagnitudeMax], sizes that rise by less than kBandRatioMin, or a gain outside kGainMin
/// to kGainMax. The message names the band, the value and the limit.
Status check_equaliser(const Equaliser& equaliser);

}  // namespace burnish
