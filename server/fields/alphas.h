#pragma once

#include <vector>

#include "server/fields/fields_view.h"
#include "server/prepare/prepared_mesh.h"

namespace burnish {

/// α1 and α2 of every cell of the finest depth (section 4.3). Units: user units.
struct CellAlphas {
  std::vector<float> alpha1, alpha2;
  bool operator==(const CellAlphas&) const = default;
};

/// The sources of the cells' shares of S beside their integrals. Needs: both outlive it.
struct CellMetric {
  CellMetric(const CellAlphas& of_cells, const LineView& held_lines = {})
      : alphas(of_cells), held(held_lines) {}
  const CellAlphas& alphas;
  LineView held;
};

/// α1 and α2 of one cell.
struct CellAlpha {
  float first, second;
  bool operator==(const CellAlpha&) const = default;
};

/// Returns the α that a curve gives to a cell.
CellAlpha follow_curve(const TransferCurve& curve, const CellCurvature& of);

/// Computes α1 and α2 from a metric.
void evaluate(const MetricView& metric, const PreparedMesh& prepared, CellAlphas& alphas);

}  // namespace burnish
