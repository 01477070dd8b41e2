#include "server/rpc/calls/upload_cell_fields_call.h"

#include "common/wire/edit_wire.h"
#include "common/wire/session_wire.h"
#include "server/rpc/transport/message_bytes.h"

namespace burnish {

void UploadCellFieldsCall::begin() {
  silence_.start(self(), [this](const Status& status) { end(status); });
  read_next();
}

void UploadCellFieldsCall::read_next() {
  silence_.wait();
  StartRead(&received_);
}

void UploadCellFieldsCall::OnReadDone(bool ok) {
  if (!silence_.heard()) return;
  const auto take = [call = self(), ok] {
    if (!ok) return call->end(call->apply());
    const Status status = call->take_request();
    if (!status.is_ok()) return call->end(status);
    call->read_next();
  };
  calls_.executor.post(
      take, [call = self()](const Status& status) { call->end(status); }, received_.Length());
}

Status UploadCellFieldsCall::take_request() {
  RETURN_IF_ERROR(parse(received_, request_));
  if (request_.has_header()) return take_header(request_.header());
  if (!has_header_)
    return malformed(invalid_argument("an upload of cell fields must begin with its header"));
  RETURN_IF_ERROR(append_cells(request_.cells(), change_));
  if (change_.cells.size() <= announced_cells_) return Status::ok();
  return invalid_argument("the upload has more than the announced " +
                          std::to_string(announced_cells_) + " cells");
}

Status UploadCellFieldsCall::take_header(const v1::CellFieldsHeader& header) {
  if (has_header_)
    return malformed(invalid_argument("an upload of cell fields must have only one header"));
  RETURN_IF_ERROR(check_references(header));
  RETURN_IF_ERROR(check_edit_id(header.edit_id()));
  if (header.cells() > kCellFieldsPerEditMax)
    return resource_exhausted("the edit sets " + std::to_string(header.cells()) +
                              " cells, the limit is " + std::to_string(kCellFieldsPerEditMax));
  RETURN_IF_ERROR(check_cell_count(header));
  has_header_ = true;
  session_ = header.session();
  edit_id_ = header.edit_id();
  announced_cells_ = header.cells();
  change_.cells.reserve(announced_cells_);
  return Status::ok();
}

// Without this, more cells than the session has would wait in memory for a refusal.
Status UploadCellFieldsCall::check_cell_count(const v1::CellFieldsHeader& header) {
  constexpr uint64_t kFewCells = 4096;
  if (header.cells() <= kFewCells) return Status::ok();
  const Progress progress = [this](std::string_view, double) { return !cancelled_; };
  const auto check = [&](Session& session) {
    const uint64_t cells = session.prepared().cells.size();
    if (header.cells() <= cells) return Status::ok();
    return invalid_argument("the edit sets " + std::to_string(header.cells()) + " cells, session " +
                            header.session() + " has " + std::to_string(cells));
  };
  return calls_.sessions.visit(header.session(), calls_.caller, check, progress);
}

Status UploadCellFieldsCall::apply() {
  if (cancelled_) return cancelled("the client has gone");
  if (!has_header_) return invalid_argument("an upload of cell fields must begin with its header");
  if (change_.cells.size() != announced_cells_)
    return data_loss("the upload ended after " + std::to_string(change_.cells.size()) + " of " +
                     std::to_string(announced_cells_) + " cells");
  const Edit edit{edit_id_, std::move(change_)};
  const Progress progress = [this](std::string_view, double) { return !cancelled_; };
  if (calls_.may_stay) RETURN_IF_ERROR(calls_.may_stay());
  ASSIGN_OR_RETURN(const ApplyOutcome outcome,
                   calls_.sessions.apply(session_, calls_.caller, {&edit, 1}, progress));
  serialize(to_wire(outcome), response_);
  return Status::ok();
}

}  // namespace burnish
