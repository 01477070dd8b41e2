#pragma once

#include <span>

#include "burnish/v1/library.pb.h"
#include "common/base/status.h"
#include "common/service/scan_pages.h"

namespace burnish {

v1::FetchPagesRequest to_wire(const PagesWish& wish);
/// Fails: invalid_argument naming the number of blocks and pages and its limit.
Result<PagesWish> from_wire(const v1::FetchPagesRequest& message);

v1::PagePart to_wire(const PagePart& part);
PagePart from_wire(const v1::PagePart& message);

v1::PagesDescription to_wire(const PagesDescription& description);
PagesDescription from_wire(const v1::PagesDescription& message);

}  // namespace burnish
