#include "server/solver/cpu/krylov/largest_move.h"

#include <algorithm>
#include <cmath>

#include "common/base/blocks.h"
#include "common/base/dispatch.h"

namespace burnish::cpu {

namespace {

using Lanes = float __attribute__((vector_size(16)));

// Returns the largest squared move of any vertex in the cells [begin, end). Evaluates E by one axis
// after the other.
BURNISH_DISPATCH float largest_of_cells(const std::array<int32_t, kCornersPerCell>* cell_corners,
                                        const int32_t* start, const std::array<float, 3>* local,
                                        const Lanes* p, const Lanes* a, int32_t begin,
                                        int32_t end) {
  const Lanes length = *a;
  float most = 0;
  for (int32_t cell = begin; cell < end; ++cell) {
    if (start[cell] == start[cell + 1]) continue;
    Lanes at[kCornersPerCell / 2], along_x[kCornersPerCell / 2];
    for (int pair = 0; pair < kCornersPerCell / 2; ++pair) {
      at[pair] = length * p[cell_corners[cell][2 * pair]];
      along_x[pair] = length * p[cell_corners[cell][2 * pair + 1]] - at[pair];
    }
    for (int32_t v = start[cell]; v < start[cell + 1]; ++v) {
      const auto [x, y, z] = local[v];
      const Lanes low = at[0] + x * along_x[0], low_y = at[1] + x * along_x[1];
      const Lanes high = at[2] + x * along_x[2], high_y = at[3] + x * along_x[3];
      const Lanes below = low + y * (low_y - low), above = high + y * (high_y - high);
      const Lanes moved = below + z * (above - below);
      const Lanes squared = moved * moved;
      most = std::max(most, squared[0] + squared[1] + squared[2]);
    }
  }
  return most;
}

}  // namespace

double largest_move(const SparseGrid& grid, const PointsByCell& points,
                    const std::vector<Float4>& p, const Float4& a) {
  const auto* lanes_of_p = reinterpret_cast<const Lanes*>(p.data());
  const auto* lanes_of_a = reinterpret_cast<const Lanes*>(a.data());
  const auto cell_count = grid.cell_count();
  float most = 0;
#pragma omp parallel for schedule(dynamic) reduction(max : most)
  for (int32_t begin = 0; begin < cell_count; begin += kBlock)
    most = std::max(most, largest_of_cells(grid.cell_corners.data(), points.start.data(),
                                           points.item.data(), lanes_of_p, lanes_of_a, begin,
                                           std::min(begin + kBlock, cell_count)));
  return std::sqrt(static_cast<double>(most));
}

}  // namespace burnish::cpu
