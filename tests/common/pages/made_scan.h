#pragma once

#include <filesystem>

#include "common/pages/directory.h"
#include "common/pages/page_file.h"

namespace burnish {

/// Returns a directory of three levels with 300, 2 and 1 pages, so of four blocks. Its bounds are
/// made up. Pages take 100 bytes each.
PageDirectory made_directory();

/// Returns the pages of a scan of three levels: two, two and one. Each coarser page has a patch for
/// each finer one.
std::vector<Page> made_scan_pages();

/// Writes them. Needs: the folder exists.
void write_made_scan(const std::filesystem::path& path);

/// The scan of which write_made_scan() tells.
PageScan made_scan();

}  // namespace burnish
