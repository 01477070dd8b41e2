#include "server/manager/cell_values.h"

namespace burnish {

static std::vector<float> curvatures(const Session& session, float CellCurvature::*kappa) {
  std::vector<float> values;
  values.reserve(session.prepared().curvature.size());
  for (const CellCurvature& cell : session.prepared().curvature) values.push_back(cell.*kappa);
  return values;
}

template <typename Value>
static std::vector<float> of_each(size_t cells, const Value& value) {
  std::vector<float> values(cells);
  for (size_t cell = 0; cell < cells; ++cell) values[cell] = value(cell);
  return values;
}

std::vector<float> cell_values(const Session& session, CellValue value) {
  const size_t cells = session.prepared().cells.size();
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
    case CellValue::kProtected: {
      const Protection& protection = session.edited().protection();
      return of_each(cells, [&](size_t cell) { return protection.has(cell) ? 1.f : 0.f; });
    }
    case CellValue::kCurve:
      return of_each(cells, [&](size_t cell) {
        return static_cast<float>(session.fields().ruling_curve(cell));
      });
  }
  return {};
}

}  // namespace burnish
