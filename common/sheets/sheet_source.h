#pragma once

#include <span>

#include "common/pages/page.h"
#include "common/sheets/bake_sheet.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"

namespace burnish {

/// A page with a sheet of its own.
struct SheetedPage {
  const Page* page;
  const PageCharts* charts;
  const Sheet* sheet;
};

/// Returns the surface of several pages with their sheets, filtered by Catmull-Rom splines. `step`:
/// of PageGrid, file units. Keeps pointers to the sheets.
BakeSource source_of_sheets(std::span<const SheetedPage> pages, double step);

}  // namespace burnish
