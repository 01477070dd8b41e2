#include "common/wire/session_wire.h"

#include "common/base/text.h"
#include "common/wire/edit_wire.h"
#include "common/wire/format_wire.h"
#include "common/wire/measures_wire.h"

namespace burnish {

v1::OpenSessionRequest to_wire(const SessionWish& wish) {
  v1::OpenSessionRequest message;
  write_fields(wish, message);
  return message;
}

Result<SessionWish> from_wire(const v1::OpenSessionRequest& message) {
  auto wish = read_record<SessionWish>(message);
  RETURN_IF_ERROR(check_name("the scan's name or id", wish.scan));
  if (!wish.name.empty()) RETURN_IF_ERROR(check_name("the session's name", wish.name));
  ASSIGN_OR_RETURN(wish.key, prepared_key_from_wire(wish.key));
  return wish;
}

v1::SessionInfo to_wire(const SessionInfo& session) {
  v1::SessionInfo message;
  write_fields(session, message);
  return message;
}

Result<SessionInfo> from_wire(const v1::SessionInfo& message) {
  auto session = read_record<SessionInfo>(message);
  ASSIGN_OR_RETURN(session.key, prepared_key_from_wire(session.key));
  return session;
}

v1::SessionState to_wire(const SessionState& state) {
  v1::SessionState message;
  *message.mutable_session() = to_wire(state.session);
  write_settings(state.settings, message);
  write_fields(state, message);
  if (state.walls.share > 0) *message.mutable_walls() = to_wire(state.walls);
  return message;
}

Result<SessionState> from_wire(const v1::SessionState& message) {
  SessionState state;
  ASSIGN_OR_RETURN(state.session, from_wire(message.session()));
  ASSIGN_OR_RETURN(state.settings, read_settings(message));
  read_fields(message, state);
  state.walls = from_wire(message.walls());
  return state;
}

v1::ApplyResponse to_wire(const ApplyOutcome& outcome) {
  v1::ApplyResponse message;
  write_fields(outcome, message);
  return message;
}

ApplyOutcome from_wire(const v1::ApplyResponse& message) {
  return read_record<ApplyOutcome>(message);
}

v1::ExportRequest to_wire(const std::string& session, const ExportWish& wish) {
  v1::ExportRequest message;
  message.set_session(session);
  message.set_format(to_wire(wish.format));
  if (wish.cycles > 0) {
    message.set_cycles(wish.cycles);
  } else if (wish.exact) {
    message.set_exact(true);
  }
  message.set_deviation(wish.deviation);
  message.set_with_files(wish.with_files);
  return message;
}

v1::CellValue to_wire(CellValue value) {
  return static_cast<v1::CellValue>(static_cast<int>(value) + v1::CELL_VALUE_BETA);
}

Result<CellValue> from_wire(v1::CellValue value) {
  for (const CellValue known :
       {CellValue::kBeta, CellValue::kKappa1, CellValue::kKappa2, CellValue::kAlpha1,
        CellValue::kAlpha2, CellValue::kProtected, CellValue::kCurve})
    if (to_wire(known) == value) return known;
  return invalid_argument(
      "cell value " + std::to_string(static_cast<int>(value)) +
      " is none of 1 (beta), 2 and 3 (kappa), 4 and 5 (alpha), 6 (protected), 7 (curve)");
}

Result<ExportWish> from_wire(const v1::ExportRequest& message) {
  ExportWish wish;
  ASSIGN_OR_RETURN(wish.format, from_wire(message.format()));
  wish.exact = message.has_exact() && message.exact();
  wish.deviation = message.deviation();
  wish.with_files = message.with_files();
  if (message.has_cycles()) {
    if (message.cycles() < 1 || message.cycles() > kExportCyclesMax)
      return invalid_argument("cycles " + std::to_string(message.cycles()) + " is outside 1.." +
                              std::to_string(kExportCyclesMax));
    wish.cycles = message.cycles();
  }
  return wish;
}

v1::ExportSummary to_wire(const ExportSummary& summary) {
  v1::ExportSummary message;
  write_fields(summary, message);
  message.set_edits(summary.edits);
  message.set_is_archive(summary.is_archive);
  message.set_volume(summary.volume);
  message.set_lost_volume(summary.lost_volume);
  if (summary.deviation)
    *message.mutable_deviation() = to_wire(SessionDeviation{*summary.deviation, summary.converged});
  return message;
}

Result<ExportSummary> from_wire(const v1::ExportSummary& message) {
  auto summary = read_record<ExportSummary>(message);
  summary.edits = message.edits();
  summary.is_archive = message.is_archive();
  summary.volume = message.volume();
  summary.lost_volume = message.lost_volume();
  if (message.has_deviation()) {
    ASSIGN_OR_RETURN(const SessionDeviation measured, from_wire(message.deviation()));
    summary.deviation = measured.deviation;
  }
  return summary;
}

}  // namespace burnish
