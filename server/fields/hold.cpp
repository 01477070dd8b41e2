#include "server/fields/hold.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/fields/cell_layers.h"

namespace burnish {

// At this α in grid units a pull at a held cell moves it by some thousandths of its edge.
static constexpr double kStiffnessCells = 250;

Hold make_hold(const PreparedMesh& prepared, std::vector<int32_t> cells) {
  Hold hold{std::move(cells), {}};
  if (hold.cells.empty()) return hold;
  const std::vector<uint8_t> layer = layers_from(prepared, hold.cells, kHoldBandCells);
  hold.weight.reserve(layer.size());
  for (const uint8_t steps : layer) {
    const float left = 1 - float(steps) / (kHoldBandCells + 1);
    hold.weight.push_back(left * left * (3 - 2 * left));
  }
  return hold;
}

double held_alpha(double alpha, double weight, double alpha_of_grid) {
  const double contrast =
      std::clamp(kStiffnessCells * alpha_of_grid / alpha, 1.0, kHoldContrastMax);
  return alpha * std::pow(contrast, weight);
}

}  // namespace burnish
