#pragma once

#include "burnish/v1/library.pb.h"
#include "common/service/scan_info.h"

namespace burnish {

v1::ImportHeader to_wire(const ImportHeader& header);
/// Fails: invalid_argument naming the field, its value and its limit.
Result<ImportHeader> from_wire(const v1::ImportHeader& message);

v1::FetchViewRequest to_wire(const ViewWish& wish);
/// Fails: invalid_argument naming the field, its value and its limit.
Result<ViewWish> from_wire(const v1::FetchViewRequest& message);

v1::ScanInfo to_wire(const ScanInfo& scan);
Result<ScanInfo> from_wire(const v1::ScanInfo& message);

v1::ScanDescription to_wire(const ScanDescription& description);
Result<ScanDescription> from_wire(const v1::ScanDescription& message);

}  // namespace burnish
