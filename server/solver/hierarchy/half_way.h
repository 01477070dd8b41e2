#pragma once

#include <array>
#include <cstdint>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// A cell's corners and those of its children stand at its 3×3×3 half-way points, x fastest.
inline constexpr int kHalfWayPoints = 27;

/// The half-way point of its parent at which a cell's corner a stands.
uint8_t place_in_parent(const GridKey& cell, int a);

/// The trilinear weights of a cell's eight corners at each half-way point.
const std::array<std::array<float, kCornersPerCell>, kHalfWayPoints>& half_way_weights();

/// The same without zeros: the corners that weigh on a point, rising.
struct PositiveWeights {
  int count = 0;
  std::array<int8_t, kCornersPerCell> corner;
  std::array<float, kCornersPerCell> weight;
};
const PositiveWeights& positive_weights(int place);

}  // namespace burnish
