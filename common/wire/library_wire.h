#pragma once

#include "burnish/v1/library.pb.h"
#include "common/edit/proposed_edges.h"
#include "common/service/scan_info.h"

namespace burnish {

v1::ImportHeader to_wire(const ImportHeader& header);
/// Fails: invalid_argument naming the field, its value and its limit.
Result<ImportHeader> from_wire(const v1::ImportHeader& message);

v1::ScanInfo to_wire(const ScanInfo& scan);
Result<ScanInfo> from_wire(const v1::ScanInfo& message);

v1::ScanDescription to_wire(const ScanDescription& description);
Result<ScanDescription> from_wire(const v1::ScanDescription& message);

v1::EdgeProposal to_wire(const EdgeProposal& proposal);
/// Fails: invalid_argument for an unknown kind of filter.
Result<EdgeProposal> from_wire(const v1::EdgeProposal& message);

}  // namespace burnish
