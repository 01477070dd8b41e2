#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/base/types.h"
#include "common/pages/page.h"
#include "common/sheets/chart.h"
#include "common/sheets/push_pull.h"
#include "common/sheets/sheet_layout.h"

namespace burnish {

/// A textured surface from which sheets are baked: that of the scan with its pictures, or finer
/// pages with their sheets.
struct BakeSource {
  std::vector<std::array<Vec3d, 3>> triangles;  ///< corners in steps of PageGrid
  /// Returns the texel where a triangle's corners have these weights, whose sum is 1.
  std::function<Texel(uint32_t triangle, const Vec3d& weights)> texel;
};

/// How a sheet is drawn.
struct BakeWish {
  SheetLayout layout;          ///< of chart_sizes() at the same density
  double texels_per_step = 0;  ///< of the sheet
  int samples_per_side = 1;    ///< of a texel: 1 where the source is as coarse, 2 where it is finer
};

/// Draws the source onto a page's charts, orthographically along each chart's normal. Where several
/// triangles face a texel, the one nearest to the page's surface counts. The gutter goes on
/// with what lies up to 6 texels above or below the page's border. Fills all other texels smoothly
/// from their surroundings, so that filters and codecs find no steps there. A source that nothing
/// faces makes a black, opaque sheet. Returns the texels row by row. The same input gives the same
/// bytes. Memory: 20 bytes a sample of the largest chart, 20 a texel of the sheet.
std::vector<Rgba8> bake_sheet(const Page& page, const PageCharts& charts, const BakeWish& wish,
                              const BakeSource& source);

}  // namespace burnish
