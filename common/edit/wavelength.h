#pragma once

#include <algorithm>
#include <numbers>

#include "common/base/limits.h"

namespace burnish {

/// α as a length. The response to a wave of wave number k is (α² + β (kL)²) / (α² + (kL)²), L the
/// scan's unit of length. It is halfway between 1 and β at kL = α, so at the wavelength 2πL/α.
/// At β = 0 this wave is halved; shorter ones lose more, longer ones less.

inline constexpr double kWaveCellsMin = 2;  // a grid holds no shorter wave

/// Returns the wavelength of α. Units: as `length_unit`, which is L.
inline double wavelength_of_alpha(double length_unit, double alpha) {
  return 2 * std::numbers::pi * length_unit / alpha;
}

/// Returns the α of a wavelength, within the limits of α. Needs: wavelength > 0.
inline double alpha_of_wavelength(double length_unit, double wavelength) {
  return std::clamp(2 * std::numbers::pi * length_unit / wavelength, kAlphaMin, kAlphaMax);
}

/// Returns the α of the shortest wave that a grid holds. Units: both lengths alike.
inline double alpha_of_grid_limit(double length_unit, double cell_size) {
  return alpha_of_wavelength(length_unit, kWaveCellsMin * cell_size);
}

}  // namespace burnish
