#pragma once

#include <filesystem>

#include "common/base/progress.h"
#include "common/base/status.h"
#include "server/prepare/pages/page_vertices.h"
#include "server/prepare/pages/pages_report.h"
#include "server/prepare/preparation_need.h"

namespace burnish {

struct PagesOptions {
  int threads = 0;                      ///< 0: all cores
  PreparationBudget* budget = nullptr;  ///< what it may take; null: what the machine has
  ScratchSpace space;                   ///< of all large arrays
};

/// Writes the page file of a scan (common/pages/page_format.h). Level 0 is the scan, without the
/// triangles that name a vertex twice, which nobody can see. Each coarser level has about half the
/// triangles; the root is one page. Where pictures make the pages of level 0 small, level 1 has the
/// same triangles on fuller pages.
/// Needs: a valid mesh (validate()) with its statistics.
/// Asks the budget before it takes memory.
/// Fails: resource_exhausted naming bytes and limit; cancelled; what writing says. Then the path is
/// as it was.
/// Deterministic: the same bytes for any number of threads.
Status build_pages(const PagesInput& scan, const std::filesystem::path& path,
                   const PagesOptions& options = {}, const Progress& progress = {},
                   PagesReport* report = nullptr);

}  // namespace burnish
