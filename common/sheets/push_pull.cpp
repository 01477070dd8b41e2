#include "common/sheets/push_pull.h"

#include <algorithm>
#include <array>

namespace burnish {

namespace {

/// Returns the means of the known texels of each 2 x 2.
TexelGrid pulled(const TexelGrid& fine) {
  TexelGrid coarse((fine.width + 1) / 2, (fine.height + 1) / 2);
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      Texel sum = Texel::Zero();
      float count = 0;
      for (int fy = 2 * y; fy < std::min(2 * y + 2, fine.height); ++fy)
        for (int fx = 2 * x; fx < std::min(2 * x + 2, fine.width); ++fx) {
          if (fine.is_known[fine.at(fx, fy)] == 0) continue;
          sum += fine.texels[fine.at(fx, fy)];
          ++count;
        }
      if (count == 0) continue;
      coarse.texels[coarse.at(x, y)] = sum / count;
      coarse.is_known[coarse.at(x, y)] = 1;
    }
  return coarse;
}

/// Interpolates between the four coarse texels around a fine one.
Texel between(const TexelGrid& coarse, int x, int y) {
  const auto near = [](int place) { return place / 2; };
  const auto far = [](int place, int size) {
    return std::clamp(place / 2 + (place % 2 == 0 ? -1 : 1), 0, size - 1);
  };
  const std::array<int, 2> xs = {near(x), far(x, coarse.width)};
  const std::array<int, 2> ys = {near(y), far(y, coarse.height)};
  const auto row = [&](int cy) -> Texel {
    return 0.75f * coarse.texels[coarse.at(xs[0], cy)] +
           0.25f * coarse.texels[coarse.at(xs[1], cy)];
  };
  return 0.75f * row(ys[0]) + 0.25f * row(ys[1]);
}

}  // namespace

void push_pull(TexelGrid& grid) {
  const auto known = std::ranges::count(grid.is_known, 1);
  if (known == 0 || known == std::ssize(grid.is_known)) return;
  TexelGrid coarse = pulled(grid);
  push_pull(coarse);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      if (grid.is_known[grid.at(x, y)] == 0) grid.texels[grid.at(x, y)] = between(coarse, x, y);
  std::ranges::fill(grid.is_known, 1);
}

}  // namespace burnish
