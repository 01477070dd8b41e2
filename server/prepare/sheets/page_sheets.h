#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "common/base/status.h"
#include "common/pages/page.h"
#include "common/sheets/bake_sheet.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"
#include "common/sheets/sheet_limits.h"

namespace burnish {

/// The sheets of one page and what they lie on.
struct PageSheets {
  PageCharts charts;
  std::vector<Sheet> sheets;  ///< the finest first

  uint64_t texels() const;
};

/// How the sheets of a page are made.
struct PageSheetsWish {
  double step = 1;           ///< of PageGrid, file units
  double density = 0;        ///< that the finest sheet gets if it fits; texels per file unit
  int samples_per_side = 1;  ///< of a texel of the finest sheet
  size_t sheets_max = kSheetsPerPageMax;  ///< the finest ones; at least 1
  /// Returns the source of the finest sheet, whose density is known now.
  std::function<Result<BakeSource>(double density)> source;
  /// Is asked often; leaves cancelled work by an exception.
  std::function<void()> ask = [] {};
};

/// Returns the area of a page's triangles, file units². At least that of a triangle of some steps
/// for each, so that densities are finite.
double page_area(const Page& page, double step);

/// Cuts a page into charts and bakes its sheets, the coarser ones from the finest. Deterministic.
/// Needs: check_page() is ok, and the page is as decode_page() returns it; density > 0.
/// Fails: as `source` does; invalid_argument (a density that no sheet can have).
Result<PageSheets> make_page_sheets(const Page& page, const PageSheetsWish& wish);

}  // namespace burnish
