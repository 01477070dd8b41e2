#include "server/rpc/calls/export_call.h"

#include "common/wire/format_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {

void ExportCall::begin() {
  post([](ExportCall& call) {
    const Status status = call.solve();
    if (!status.is_ok()) return call.end(status);
    call.send_next();
  });
}

Status ExportCall::solve() {
  ASSIGN_OR_RETURN(const ExportWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(
      file_, calls_.sessions.export_mesh(request_.session(), wish, calls_.caller, progress()));
  return Status::ok();
}

void ExportCall::OnWriteDone(bool ok) {
  const bool was_chunk = events_.written().has_chunk();
  events_.on_write_done(ok);
  // Also after a mere progress event: after a failed write nothing more is written.
  if (!ok) return end(cancelled("the client has gone"));
  if (!was_chunk) return;
  post(Pool::kSession, [](ExportCall& call) { call.send_next(); });
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

}  // namespace burnish
