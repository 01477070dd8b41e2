#include "common/wire/session_wire.h"

#include "common/base/text.h"
#include "common/wire/edit_wire.h"
#include "common/wire/format_wire.h"
#include "common/wire/measures_wire.h"

namespace burnish {

v1::OpenSessionRequest to_wire(const SessionWish& wish) {
  v1::OpenSessionRequest message;
  message.set_scan(wish.scan);
  message.set_name(wish.name);
  message.set_depth(wish.key.depth);
  message.set_curvature_radius(wish.key.curvature_radius);
  return message;
}

Result<SessionWish> from_wire(const v1::OpenSessionRequest& message) {
  SessionWish wish;
  RETURN_IF_ERROR(check_name("the scan's name or id", message.scan()));
  wish.scan = message.scan();
  if (!message.name().empty()) RETURN_IF_ERROR(check_name("the session's name", message.name()));
  wish.name = message.name();
  ASSIGN_OR_RETURN(wish.key, prepared_key_from_wire(message.depth(), message.curvature_radius()));
  return wish;
}

v1::SessionInfo to_wire(const SessionInfo& session) {
  v1::SessionInfo message;
  message.set_id(session.id);
  message.set_name(session.name);
  message.set_scan_id(session.scan_id);
  message.set_depth(session.key.depth);
  message.set_curvature_radius(session.key.curvature_radius);
  message.set_created_unix_seconds(session.created_unix_seconds);
  message.set_edits(session.edits);
  message.set_in_memory(session.in_memory);
  return message;
}

Result<SessionInfo> from_wire(const v1::SessionInfo& message) {
  SessionInfo session;
  session.id = message.id();
  session.name = message.name();
  session.scan_id = message.scan_id();
  ASSIGN_OR_RETURN(session.key,
                   prepared_key_from_wire(message.depth(), message.curvature_radius()));
  session.created_unix_seconds = message.created_unix_seconds();
  session.edits = message.edits();
  session.in_memory = message.in_memory();
  return session;
}

v1::SessionState to_wire(const SessionState& state) {
  v1::SessionState message;
  *message.mutable_session() = to_wire(state.session);
  write_settings(state.settings, message);
  message.set_cycles(state.cycles);
  message.set_energy(state.energy);
  message.set_residual(state.residual);
  message.set_distance(state.distance);
  message.set_memory_bytes(state.memory_bytes);
  message.set_backend(state.backend);
  message.set_rims(state.rims);
  message.set_rims_held(state.rims_held);
  if (state.walls.share > 0) *message.mutable_walls() = to_wire(state.walls);
  return message;
}

Result<SessionState> from_wire(const v1::SessionState& message) {
  SessionState state;
  ASSIGN_OR_RETURN(state.session, from_wire(message.session()));
  ASSIGN_OR_RETURN(state.settings, read_settings(message));
  state.cycles = message.cycles();
  state.energy = message.energy();
  state.residual = message.residual();
  state.distance = message.distance();
  state.memory_bytes = message.memory_bytes();
  state.backend = message.backend();
  state.rims = message.rims();
  state.rims_held = message.rims_held();
  state.walls = from_wire(message.walls());
  return state;
}

v1::ApplyResponse to_wire(const ApplyOutcome& outcome) {
  v1::ApplyResponse message;
  message.set_applied(outcome.applied);
  message.set_known(outcome.known);
  message.set_edits(outcome.edits);
  for (const uint64_t entry : outcome.entries) message.add_entries(entry);
  return message;
}

ApplyOutcome from_wire(const v1::ApplyResponse& message) {
  return {message.applied(),
          message.known(),
          message.edits(),
          {message.entries().begin(), message.entries().end()}};
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
  message.set_size_bytes(summary.size_bytes);
  message.set_sha256(summary.sha256);
  message.set_vertices(summary.vertices);
  message.set_triangles(summary.triangles);
  message.set_cycles(summary.cycles);
  message.set_converged(summary.converged);
  message.set_energy(summary.energy);
  message.set_residual(summary.residual);
  message.set_distance(summary.distance);
  message.set_assemble_seconds(summary.assemble_seconds);
  message.set_solve_seconds(summary.solve_seconds);
  for (const std::string& name : summary.left_out) message.add_left_out(name);
  message.set_edits(summary.edits);
  message.set_is_archive(summary.is_archive);
  message.set_volume(summary.volume);
  message.set_lost_volume(summary.lost_volume);
  message.set_pictures(summary.pictures);
  if (summary.deviation)
    *message.mutable_deviation() = to_wire(SessionDeviation{*summary.deviation, summary.converged});
  return message;
}

Result<ExportSummary> from_wire(const v1::ExportSummary& message) {
  ExportSummary summary;
  summary.size_bytes = message.size_bytes();
  summary.sha256 = message.sha256();
  summary.vertices = message.vertices();
  summary.triangles = message.triangles();
  summary.cycles = message.cycles();
  summary.converged = message.converged();
  summary.energy = message.energy();
  summary.residual = message.residual();
  summary.distance = message.distance();
  summary.assemble_seconds = message.assemble_seconds();
  summary.solve_seconds = message.solve_seconds();
  summary.left_out.assign(message.left_out().begin(), message.left_out().end());
  summary.edits = message.edits();
  summary.is_archive = message.is_archive();
  summary.volume = message.volume();
  summary.lost_volume = message.lost_volume();
  summary.pictures = message.pictures();
  if (message.has_deviation()) {
    ASSIGN_OR_RETURN(const SessionDeviation measured, from_wire(message.deviation()));
    summary.deviation = measured.deviation;
  }
  return summary;
}

}  // namespace burnish
