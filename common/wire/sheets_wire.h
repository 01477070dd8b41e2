#pragma once

#include "burnish/v1/library.pb.h"
#include "common/base/status.h"
#include "common/service/scan_sheets.h"

namespace burnish {

v1::FetchSheetsRequest to_wire(const SheetsWish& wish);
/// Fails: invalid_argument naming the number of blocks, charts and sheets and its limit.
Result<SheetsWish> from_wire(const v1::FetchSheetsRequest& message);

v1::SheetPart to_wire(const SheetPart& part);
SheetPart from_wire(const v1::SheetPart& message);

v1::SheetsDescription to_wire(const SheetsDescription& description);
SheetsDescription from_wire(const v1::SheetsDescription& message);

}  // namespace burnish
