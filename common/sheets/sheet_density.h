#pragma once

#include <cstddef>
#include <span>

#include "common/pages/page.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet_layout.h"

namespace burnish {

/// Texels along a mean edge of a page's triangles. A picture that rests at edges of 6 pixels has a
/// texel for each pixel, and some to spare.
inline constexpr double kTexelsPerEdge = 8;

/// Returns the density at which a mean edge has as many texels. A triangle counts as equilateral.
double edge_density(double texels_per_edge, size_t triangles, double area);

/// Returns the density of a page above level 0: kTexelsPerEdge, but not more than the densest of
/// its finer pages has. Needs: at least one finer page.
double coarse_density(std::span<const double> finer, size_t triangles, double area);

/// Returns how many sheets a page gets, each of half the density of the one before: while that has
/// at least kTexelsPerEdge / 4 texels an edge. 1..kSheetsPerPageMax.
size_t sheet_count(double density, size_t triangles, double area);

/// A density at which a page's charts fit on a sheet.
struct FittedSheet {
  double texels_per_step = 0;
  SheetLayout layout;
};

/// Lays charts out, at a lower density if they do not fit on one sheet. Needs: texels_per_step is
/// positive; at most kPageTrianglesMax charts, which fit at a low density.
FittedSheet fit_sheet(const Page& page, const PageCharts& charts, double texels_per_step);

}  // namespace burnish
