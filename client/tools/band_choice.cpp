#include "client/tools/band_choice.h"

#include <algorithm>

#include "common/base/fixed_text.h"
#include "common/base/ratio.h"
#include "common/edit/wavelength.h"

namespace burnish {

Equaliser first_bands(double cell_size, double diagonal) {
  constexpr int kBands = 4;
  const double finest = 2 * kWaveCellsMin * cell_size, coarsest = 0.15 * diagonal;
  const double ratio = std::max(kBandRatioMin, power(coarsest / finest, 1.0 / (kBands - 1)));
  Equaliser equaliser;
  double size = finest;
  for (int band = 0; band < kBands; ++band, size *= ratio) equaliser.bands.push_back({size, 1});
  return equaliser;
}

std::string details_of(const Equaliser& equaliser, size_t number) {
  constexpr int kDigits = 3;
  const std::string size = fixed_text(equaliser.bands[number - 1].size, kDigits);
  if (number == 1) return "finer than " + size;
  return fixed_text(equaliser.bands[number - 2].size, kDigits) + " to " + size;
}

}  // namespace burnish
