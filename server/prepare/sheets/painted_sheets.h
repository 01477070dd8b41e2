#pragma once

#include <cstddef>
#include <functional>
#include <limits>

#include "common/base/status.h"
#include "common/pages/page.h"
#include "common/sheets/sheet_limits.h"
#include "server/prepare/sheets/page_paint.h"
#include "server/prepare/sheets/page_sheets.h"
#include "server/prepare/sheets/picture_tiles.h"

namespace burnish {

/// How sheets are made from a scan's pictures.
struct PaintedSheetsWish {
  double step = 1;  ///< of PageGrid, file units
  /// Density of the finest sheet, texels per file unit; positive.
  double density_max = std::numeric_limits<double>::infinity();
  size_t sheets_max = kSheetsPerPageMax;  ///< the finest ones; at least 1
  std::function<void()> ask = [] {};      ///< as PageSheetsWish::ask
};

/// Makes the sheets of a page from the scan's pictures, about as dense as these are. A page without
/// any gets what a coarse page has. For one thread. Needs: the paint is of this page and these
/// tiles. Fails: as make_page_sheets(); as a tile cannot be read.
Result<PageSheets> make_painted_sheets(const Page& page, const PagePaint& paint,
                                       const PictureTiles& tiles, const PaintedSheetsWish& wish);

}  // namespace burnish
