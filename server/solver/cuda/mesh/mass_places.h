#pragma once

#include <array>
#include <cstdint>

#include "server/solver/hierarchy/cell_matrix.h"

namespace burnish::cuda {

/// The 19 different numbers among a cell's 28 masses ρ_ab. Along an axis a product of two trilinear
/// functions is (1 − x)², x(1 − x) or x², whichever function has which part. ρ_ab is the integral
/// of three of these (prepare/cell_moments.h).
struct MassPlaces {
  static constexpr int kDifferent = 19;
  std::array<uint8_t, kPairsPerCell> of_pair = {};  ///< index of each pair's number
  std::array<uint8_t, kDifferent> first_pair = {};  ///< the first pair with each number
};

constexpr MassPlaces mass_places() {
  MassPlaces places;
  int place_of_moment[27] = {};  // plus one; 0 while unknown
  uint8_t count = 0;
  for (int a = 0; a < 8; ++a)
    for (int b = a + 1; b < 8; ++b) {
      const int moment =
          (a & 1) + (b & 1) + 3 * ((a >> 1 & 1) + (b >> 1 & 1)) + 9 * ((a >> 2) + (b >> 2));
      const int pair = pair_index(a, b);
      int& place = place_of_moment[moment];
      if (place == 0) {
        places.first_pair[count] = static_cast<uint8_t>(pair);
        place = ++count;
      }
      places.of_pair[pair] = static_cast<uint8_t>(place - 1);
    }
  return places;
}

}  // namespace burnish::cuda
