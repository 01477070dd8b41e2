#include "server/solver/hierarchy/half_way.h"

#include "common/evaluation/evaluation.h"

namespace burnish {

uint8_t place_in_parent(const GridKey& cell, int a) {
  const Vec3i at = corner_offset(static_cast<int>(cell.place & 7)) + corner_offset(a);
  return static_cast<uint8_t>(at.x() + 3 * at.y() + 9 * at.z());
}

const std::array<std::array<float, kCornersPerCell>, kHalfWayPoints>& half_way_weights() {
  static const auto table = [] {
    std::array<std::array<float, kCornersPerCell>, kHalfWayPoints> weights;
    for (int place = 0; place < kHalfWayPoints; ++place)
      weights[place] = trilinear_weights(
          {place % 3 * 0.5f, place / 3 % 3 * 0.5f, static_cast<float>(place / 9) * 0.5f});
    return weights;
  }();
  return table;
}

const PositiveWeights& positive_weights(int place) {
  static const auto table = [] {
    std::array<PositiveWeights, kHalfWayPoints> of_place;
    for (int p = 0; p < kHalfWayPoints; ++p)
      for (int8_t a = 0; a < kCornersPerCell; ++a) {
        const float weight = half_way_weights()[p][a];
        if (weight == 0) continue;
        of_place[p].corner[of_place[p].count] = a;
        of_place[p].weight[of_place[p].count++] = weight;
      }
    return of_place;
  }();
  return table[place];
}

}  // namespace burnish
