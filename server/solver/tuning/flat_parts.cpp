#include "server/solver/tuning/flat_parts.h"

#include <algorithm>
#include <cmath>

namespace burnish {

// Energy goes with the square of the bend: 1e-8 is still far above the 38 bits of S on CUDA.
static constexpr double kFlatBend = 1e-4;
static constexpr double kFlatShareMin = 1e-3;  // a lone cell is flat by chance

bool has_flat_parts(const PreparedMesh& prepared) {
  double flat = 0, whole = 0;
  for (const CellCurvature& cell : prepared.curvature) {
    const double bend =
        std::max(std::abs(cell.kappa1), std::abs(cell.kappa2)) * prepared.alpha_scale();
    whole += cell.area;
    if (bend < kFlatBend) flat += cell.area;
  }
  return flat > kFlatShareMin * whole;
}

}  // namespace burnish
