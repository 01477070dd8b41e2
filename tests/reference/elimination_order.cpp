#include "tests/reference/elimination_order.h"

#include <algorithm>
#include <span>

namespace burnish::reference {

namespace {

constexpr size_t kSmallEnough = 40;  // corners: any order is good enough

int longest_axis(const std::vector<Lattice>& corners, std::span<const int> part) {
  Lattice least = corners[part[0]];
  Lattice most = least;
  for (int corner : part) {
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], corners[corner][axis]);
      most[axis] = std::max(most[axis], corners[corner][axis]);
    }
  }
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (most[axis] - least[axis] > most[longest] - least[longest]) longest = axis;
  return most[longest] == least[longest] ? -1 : longest;
}

void dissect(const std::vector<Lattice>& corners, std::span<int> part) {
  if (part.size() <= kSmallEnough) return;
  const int axis = longest_axis(corners, part);
  if (axis < 0) return;
  const auto coordinate = [&](int corner) { return corners[corner][axis]; };
  const auto middle = part.begin() + part.size() / 2;
  std::nth_element(part.begin(), middle, part.end(),
                   [&](int a, int b) { return coordinate(a) < coordinate(b); });
  const int plane = coordinate(*middle);
  const auto above = std::partition(part.begin(), part.end(),
                                    [&](int corner) { return coordinate(corner) < plane; });
  const auto on =
      std::partition(above, part.end(), [&](int corner) { return coordinate(corner) > plane; });
  dissect(corners, {part.begin(), above});
  dissect(corners, {above, on});
}

}  // namespace

std::vector<int> elimination_order(const std::vector<Lattice>& corners,
                                   const std::vector<int>& free) {
  std::vector<int> order = free;
  dissect(corners, order);
  return order;
}

}  // namespace burnish::reference
