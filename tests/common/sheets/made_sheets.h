#pragma once

#include <filesystem>
#include <vector>

#include "common/pages/directory.h"
#include "common/sheets/chart.h"
#include "common/sheets/sheet.h"
#include "common/sheets/sheet_file.h"

namespace burnish {

/// A page with its charts and sheets, the finest first.
struct MadeSheets {
  Page page;
  PageCharts charts;
  std::vector<Sheet> sheets;
};

/// Returns a head of three, two and one pages, in three blocks. It has no bounds.
PageHead six_page_head();

/// Returns those pages. Page p has 1 + p % 3 sheets.
std::vector<MadeSheets> six_pages();

/// The origin of write_six_pages().
inline constexpr SheetOrigin kMadeOrigin{.pages_fingerprint = 11, .pictures_fingerprint = 22};

/// Writes their sheets. Needs: the folder exists.
void write_six_pages(const std::filesystem::path& path);

}  // namespace burnish
