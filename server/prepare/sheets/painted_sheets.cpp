#include "server/prepare/sheets/painted_sheets.h"

#include <algorithm>
#include <cmath>

#include "common/sheets/sheet_density.h"
#include "server/prepare/sheets/picture_sampler.h"

namespace burnish {

/// Returns the density at which an area fills a sheet.
static double densest_density(double area) {
  return kSheetSideMax / std::sqrt(area);
}

/// Returns the density that a page's pictures need. A page without any gets what a coarse page has.
static double painted_density(const Page& page, const PagePaint& paint, double step) {
  const size_t triangles = page.triangles.size();
  const double area = page_area(page, step);
  const double needed = paint.needed_density() / step;
  if (needed == 0) return edge_density(kTexelsPerEdge, triangles, area);
  return std::max(needed, edge_density(kTexelsPerEdge / 4, triangles, area));
}

Result<PageSheets> make_painted_sheets(const Page& page, const PagePaint& paint,
                                       const PictureTiles& tiles, const PaintedSheetsWish& wish) {
  PictureSampler sampler(tiles);
  const double native = painted_density(page, paint, wish.step);
  const double most = std::min(densest_density(page_area(page, wish.step)), wish.density_max);
  PageSheetsWish sheets{.step = wish.step, .sheets_max = wish.sheets_max, .ask = wish.ask};
  sheets.density = std::min(native, most);
  // A sheet that is coarser than the pictures has two of their texels for one of its own in places.
  sheets.samples_per_side = sheets.density < native ? 2 : 1;
  sheets.source = [&](double density) -> Result<BakeSource> {
    return paint.source(sampler, density * wish.step);
  };
  auto made = make_page_sheets(page, sheets);
  RETURN_IF_ERROR(sampler.status());
  return made;
}

}  // namespace burnish
