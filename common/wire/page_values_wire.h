#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/service/page_values.h"

namespace burnish {

v1::GetPageValuesRequest to_wire(const PageValuesWish& wish);
/// Fails: invalid_argument naming the number of pages and its limit, or the value.
Result<PageValuesWish> from_wire(const v1::GetPageValuesRequest& message);

v1::PageValues to_wire(const PageValues& values);
/// Fails: data_loss for bounds that are not finite or more vertices than a page has.
Result<PageValues> from_wire(const v1::PageValues& message);

}  // namespace burnish
