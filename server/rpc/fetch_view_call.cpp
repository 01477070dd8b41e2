#include "server/rpc/fetch_view_call.h"

#include "common/transfer/chunk.h"
#include "common/wire/format_wire.h"
#include "common/wire/library_wire.h"

namespace burnish {

FetchViewCall::FetchViewCall(const CallContext& calls, const v1::FetchViewRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::FetchViewEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void FetchViewCall::begin() {
  calls_.executor.post(
      [call = self()] {
        const Status status = call->open();
        if (!status.is_ok()) return call->end(status);
        call->send_header();
      },
      [call = self()](const Status& status) { call->end(status); });
}

Status FetchViewCall::open() {
  ASSIGN_OR_RETURN(const ViewWish wish, from_wire(request_));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(wish.scan));
  const Progress progress = [this](std::string_view phase, double fraction) {
    return report_progress(phase, fraction);
  };
  ASSIGN_OR_RETURN(view_, calls_.store.open_view(scan.id, resolve(wish.key, scan),
                                                 wish.triangles_max, progress));
  return Status::ok();
}

void FetchViewCall::send_header() {
  v1::FetchViewEvent event;
  event.mutable_header()->set_size_bytes(view_->bytes.size());
  event.mutable_header()->set_vertices(view_->vertices);
  event.mutable_header()->set_triangles(view_->triangles);
  event.mutable_header()->set_scan_vertices(view_->scan_vertices);
  event.mutable_header()->set_scan_triangles(view_->scan_triangles);
  events_.push(std::move(event));
}

void FetchViewCall::OnWriteDone(bool ok) {
  const bool was_progress = events_.written().has_progress();
  events_.on_write_done(ok);
  // Also after a mere progress event: after a failed write nothing more is written.
  if (!ok) return end(cancelled("the client has gone"));
  if (was_progress) return;
  run_guarded([this] { send_next(); }, [this](const Status& status) { end(status); });
}

void FetchViewCall::send_next() {
  const std::string_view all(reinterpret_cast<const char*>(view_->bytes.data()),
                             view_->bytes.size());
  const std::string_view piece = all.substr(sent_bytes_, kChunkBytes);
  if (piece.empty()) return events_.close(grpc::Status::OK);
  v1::FetchViewEvent event;
  set_chunk(sent_bytes_, piece, *event.mutable_chunk());
  sent_bytes_ += piece.size();
  events_.push(std::move(event));
}

bool FetchViewCall::report_progress(std::string_view phase, double fraction) {
  v1::FetchViewEvent event;
  event.mutable_progress()->set_phase(std::string(phase));
  event.mutable_progress()->set_fraction(fraction);
  events_.offer(std::move(event));
  return !cancelled_;
}

}  // namespace burnish
