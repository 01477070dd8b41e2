#include "common/sheets/sheet_density.h"

#include <algorithm>
#include <cmath>

#include "common/sheets/sheet_limits.h"

namespace burnish {

double edge_density(double texels_per_edge, size_t triangles, double area) {
  const double area_of_unit_edge = std::sqrt(3.0) / 4;
  return texels_per_edge * std::sqrt(area_of_unit_edge * static_cast<double>(triangles) / area);
}

double coarse_density(std::span<const double> finer, size_t triangles, double area) {
  return std::min(std::ranges::max(finer), edge_density(kTexelsPerEdge, triangles, area));
}

size_t sheet_count(double density, size_t triangles, double area) {
  const double least = edge_density(kTexelsPerEdge / 4, triangles, area);
  size_t sheets = 1;
  for (double half = density / 2; half >= least && sheets < kSheetsPerPageMax; half /= 2) ++sheets;
  return sheets;
}

FittedSheet fit_sheet(const Page& page, const PageCharts& charts, double texels_per_step) {
  constexpr double kStep = 0.9;  // the report names what is coarser; small steps lose little
  for (double density = texels_per_step;; density *= kStep)
    if (auto layout = lay_out_sheet(chart_sizes(page, charts, density)))
      return {density, std::move(*layout)};
}

}  // namespace burnish
