#pragma once

#include "burnish/v1/editing.pb.h"
#include "common/service/session_info.h"

namespace burnish {

v1::OpenSessionRequest to_wire(const SessionWish& wish);
/// Fails: invalid_argument naming the field, its value and its limit.
Result<SessionWish> from_wire(const v1::OpenSessionRequest& message);

v1::SessionInfo to_wire(const SessionInfo& session);
Result<SessionInfo> from_wire(const v1::SessionInfo& message);

v1::SessionState to_wire(const SessionState& state);
Result<SessionState> from_wire(const v1::SessionState& message);

v1::ApplyResponse to_wire(const ApplyOutcome& outcome);
ApplyOutcome from_wire(const v1::ApplyResponse& message);

v1::CellValue to_wire(CellValue value);
/// Fails: invalid_argument for an unspecified or unknown value.
Result<CellValue> from_wire(v1::CellValue value);

v1::ExportRequest to_wire(const std::string& session, const ExportWish& wish);
/// Fails: invalid_argument for a format that is not written, or cycles outside their limits.
Result<ExportWish> from_wire(const v1::ExportRequest& message);

v1::ExportSummary to_wire(const ExportSummary& summary);
/// Fails: as the deviation is damaged.
Result<ExportSummary> from_wire(const v1::ExportSummary& message);

}  // namespace burnish
