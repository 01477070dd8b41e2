#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "common/mesh/rewrite/moved/seam_wish.h"

namespace burnish {

/// Sheets of so many different wishes are kept per scan, beside the scan's own.
inline constexpr size_t kLevelledSheetsMax = 4;

/// Names the sheets whose seams are levelled as wished: the same number for the same amount and the
/// same region on all servers. Returns 0 for the scan's own sheets.
uint64_t seams_version(const SeamWish& wish);

/// Notes that a client asked for these sheets of a scan now, and removes those beyond
/// kLevelledSheetsMax that nobody has asked for the longest. A removed file stays readable for
/// those who have it open.
void keep_levelled_sheets(const std::filesystem::path& scan_folder, uint64_t version);

}  // namespace burnish
