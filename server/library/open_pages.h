#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "common/pages/page_file.h"
#include "common/sheets/sheet_file.h"
#include "server/library/open_files.h"
#include "server/memory/quota.h"

namespace burnish {

/// An open page file with its share of the server's memory.
struct ScanPages {
  std::string scan_id;
  PageFile file;
  Quota::Share memory;  ///< for the directory; pages stay on the disk
};
using OpenPages = OpenFiles<ScanPages>;

/// An open sheet file with its share of the server's memory.
struct ScanSheets {
  std::string scan_id;
  uint64_t version = 0;                    ///< of levelled seams; 0: the scan's own sheets
  std::shared_ptr<const ScanPages> pages;  ///< that it belongs to
  SheetFile file;
  Quota::Share memory;  ///< for the directory; sheets stay on the disk
};
using OpenSheets = OpenFiles<ScanSheets>;

}  // namespace burnish
