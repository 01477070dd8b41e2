#include "server/fields/alphas.h"

namespace burnish {

static float alpha_of(const TransferCurve& curve, double kappa) {
  return static_cast<float>(curve.alpha(curve.is_constant() ? 0 : kappa));
}

CellAlpha follow_curve(const TransferCurve& curve, const CellCurvature& of) {
  return {alpha_of(curve, of.kappa1), alpha_of(curve, of.kappa2)};
}

void evaluate(const MetricView& metric, const PreparedMesh& prepared, CellAlphas& alphas) {
  const auto cells = static_cast<int64_t>(prepared.cells.size());
  alphas.alpha1.resize(prepared.cells.size());
  alphas.alpha2.resize(prepared.cells.size());
  const bool is_constant = metric.curve->is_constant();
  const CellAlpha one = follow_curve(*metric.curve, {});
#pragma omp parallel for schedule(static)
  for (int64_t c = 0; c < cells; ++c) {
    const CellAlpha alpha = is_constant ? one : follow_curve(*metric.curve, prepared.curvature[c]);
    alphas.alpha1[c] = alpha.first;
    alphas.alpha2[c] = alpha.second;
  }
  for (const OwnFields& own : metric.own) {
    alphas.alpha1[own.cell] = own.alpha1;
    alphas.alpha2[own.cell] = own.alpha2;
  }
}

}  // namespace burnish
