#pragma once

#include <array>
#include <cstdint>

#include "common/grid/sparse_grid.h"

namespace burnish {

/// The 3×3×3 half-way points of a cell, x fastest. The corners of the cell and of its children are
/// at these points.
inline constexpr int kHalfWayPoints = 27;

/// Returns the half-way point of the parent at which corner a of the cell lies.
uint8_t place_in_parent(const GridKey& cell, int a);

/// Returns the trilinear weights of a cell's eight corners at each half-way point.
const std::array<std::array<float, kCornersPerCell>, kHalfWayPoints>& half_way_weights();

/// Half-way weights without zeros: the corners that weigh on a point, rising.
struct PositiveWeights {
  int count = 0;
  std::array<int8_t, kCornersPerCell> corner;
  std::array<float, kCornersPerCell> weight;
};
const PositiveWeights& positive_weights(int place);

}  // namespace burnish
