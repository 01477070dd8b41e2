#pragma once

#include <span>
#include <string>

#include "client/pages/page_item.h"
#include "common/service/scan_pages.h"
#include "common/service/scan_sheets.h"

namespace burnish {

/// Returns the request for a batch of FetchQueue. Needs: blocks and pages.
PagesWish pages_wish(const std::string& scan, std::span<const PageItem> items);

/// The same for items of sheets, which are of one version.
SheetsWish sheets_wish(const std::string& scan, std::span<const PageItem> items);

}  // namespace burnish
