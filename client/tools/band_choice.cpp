#include "client/tools/band_choice.h"

#include <algorithm>
#include <cstdio>

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
  char text[64];
  const double size = equaliser.bands[number - 1].size;
  if (number == 1) {
    std::snprintf(text, sizeof text, "finer than %.3g", size);
  } else {
    std::snprintf(text, sizeof text, "%.3g to %.3g", equaliser.bands[number - 2].size, size);
  }
  return text;
}

}  // namespace burnish
