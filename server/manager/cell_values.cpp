#include "server/manager/cell_values.h"

namespace burnish {

static std::vector<float> curvatures(const Session& session, float CellCurvature::*kappa) {
  std::vector<float> values;
  values.reserve(session.prepared().curvature.size());
  for (const CellCurvature& cell : session.prepared().curvature) values.push_back(cell.*kappa);
  return values;
}

std::vector<float> cell_values(const Session& session, CellValue value) {
  switch (value) {
    case CellValue::kBeta: {
      const std::span<const float> beta = session.fields().view().beta;
      return {beta.begin(), beta.end()};
    }
    case CellValue::kAlpha1:
      return session.fields().alphas().alpha1;
    case CellValue::kAlpha2:
      return session.fields().alphas().alpha2;
    case CellValue::kKappa1:
      return curvatures(session, &CellCurvature::kappa1);
    case CellValue::kKappa2:
      return curvatures(session, &CellCurvature::kappa2);
  }
  return {};
}

}  // namespace burnish
