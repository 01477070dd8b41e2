#include "common/mesh/statistics/thin_walls.h"

#include <cmath>

namespace burnish {

std::string describe(const ThinWalls& walls) {
  if (walls.share <= 0) return {};
  const std::string words = "Walls: " + std::to_string(std::lround(100 * walls.share)) +
                            " % of the surface is thinner than a cell; an edit of one side moves "
                            "the other.";
  if (walls.depth == 0) return words;
  return words + " At depth " + std::to_string(walls.depth) +
         ", nine tenths of that is thicker than a cell.";
}

}  // namespace burnish
