#include "server/rpc/calls/export_call.h"

#include "common/wire/format_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {

ExportCall::ExportCall(const CallContext& calls, const v1::ExportRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::ExportEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void ExportCall::begin() {
  calls_.executor.post(
      [call = self()] {
        const Status status = call->solve();
        if (!status.is_ok()) return call->end(status);
        call->send_next();
      },
      [call = self()](const Status& status) { call->end(status); });
}

Status ExportCall::solve() {
  ASSIGN_OR_RETURN(const ExportWish wish, from_wire(request_));
  const Progress progress = [this](std::string_view phase, double fraction) {
    return report_progress(phase, fraction);
  };
  ASSIGN_OR_RETURN(file_,
                   calls_.sessions.export_mesh(request_.session(), wish, calls_.caller,
                                               give_way_to(calls_.live.scheduler(), progress)));
  return Status::ok();
}

void ExportCall::OnWriteDone(bool ok) {
  const bool was_chunk = events_.written().has_chunk();
  events_.on_write_done(ok);
  // Also after a mere progress event: after a failed write nothing more is written.
  if (!ok) return end(cancelled("the client has gone"));
  if (!was_chunk) return;
  calls_.executor.post(
      Lane::kSession, [call = self()] { call->send_next(); },
      [call = self()](const Status& status) { call->end(status); });
}

void ExportCall::send_next() {
  const auto piece = file_->read(sent_bytes_);
  if (!piece.is_ok()) return end(piece.status());
  v1::ExportEvent event;
  if (piece.value().empty()) {
    *event.mutable_summary() = to_wire(file_->summary());
    events_.push(std::move(event));
    return events_.close(grpc::Status::OK);
  }
  set_chunk(sent_bytes_, piece.value(), *event.mutable_chunk());
  sent_bytes_ += piece.value().size();
  events_.push(std::move(event));
}

bool ExportCall::report_progress(std::string_view phase, double fraction) {
  v1::ExportEvent event;
  event.mutable_progress()->set_phase(std::string(phase));
  event.mutable_progress()->set_fraction(fraction);
  events_.offer(std::move(event));
  return !cancelled_;
}

}  // namespace burnish
