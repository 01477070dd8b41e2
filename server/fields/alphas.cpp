#include "server/fields/alphas.h"

namespace burnish {

void evaluate(const MetricView& metric, const PreparedMesh& prepared, CellAlphas& alphas) {
  const auto cells = static_cast<int64_t>(prepared.cells.size());
  alphas.alpha1.resize(prepared.cells.size());
  alphas.alpha2.resize(prepared.cells.size());
  const bool is_constant = metric.curve->is_constant();
  const auto alpha = [&](double kappa) { return static_cast<float>(metric.curve->alpha(kappa)); };
  const float one = alpha(0);
#pragma omp parallel for schedule(static)
  for (int64_t c = 0; c < cells; ++c) {
    alphas.alpha1[c] = is_constant ? one : alpha(prepared.curvature[c].kappa1);
    alphas.alpha2[c] = is_constant ? one : alpha(prepared.curvature[c].kappa2);
  }
  for (const OwnFields& own : metric.own) {
    alphas.alpha1[own.cell] = own.alpha1;
    alphas.alpha2[own.cell] = own.alpha2;
  }
}

}  // namespace burnish
