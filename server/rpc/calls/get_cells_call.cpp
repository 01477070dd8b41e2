#include "server/rpc/calls/get_cells_call.h"

#include "common/transfer/chunk.h"
#include "common/wire/format_wire.h"
#include "common/wire/session_wire.h"
#include "server/manager/cell_values.h"

namespace burnish {

GetCellsCall::GetCellsCall(const CallContext& calls, const v1::GetCellsRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::Chunk* chunk) { StartWrite(chunk); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void GetCellsCall::begin() {
  calls_.executor.post(
      [call = self()] {
        const Status status = call->take_values();
        if (!status.is_ok()) return call->end(status);
        call->send_next();
      },
      [call = self()](const Status& status) { call->end(status); });
}

Status GetCellsCall::take_values() {
  ASSIGN_OR_RETURN(const CellValue value, from_wire(request_.value()));
  const Progress progress = [this](std::string_view, double) { return !cancelled_; };
  const auto take = [&](Session& session) {
    values_ = cell_values(session, value);
    return Status::ok();
  };
  return calls_.sessions.visit(request_.session(), calls_.caller, take, progress);
}

void GetCellsCall::OnWriteDone(bool ok) {
  events_.on_write_done(ok);
  if (!ok) return end(cancelled("the client has gone"));
  run_guarded([this] { send_next(); }, [this](const Status& status) { end(status); });
}

void GetCellsCall::send_next() {
  const std::string_view all(reinterpret_cast<const char*>(values_.data()),
                             values_.size() * sizeof(float));
  const std::string_view piece = all.substr(sent_bytes_, kChunkBytes);
  if (piece.empty()) return events_.close(grpc::Status::OK);
  v1::Chunk chunk;
  set_chunk(sent_bytes_, piece, chunk);
  sent_bytes_ += piece.size();
  events_.push(std::move(chunk));
}

}  // namespace burnish
