#include <algorithm>

#include "client/connection/connection_state.h"
#include "common/wire/edit_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {

// Opening and editing may bring a session back into memory, which takes as long as it takes:
// these calls have no deadline of their own; keepalive finds a server that has gone.

static constexpr size_t kCellsPerMessage = 1 << 16;  // about 3 MB

Result<OpenedSession> Connection::open_session(const SessionWish& wish) {
  v1::OpenSessionResponse response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    return owner.OpenSession(&context, to_wire(wish), &response);
  }));
  OpenedSession opened;
  ASSIGN_OR_RETURN(opened.session, from_wire(response.session()));
  opened.attached = response.attached();
  return opened;
}

Result<SessionState> Connection::state(const std::string& session) {
  v1::GetStateRequest request;
  request.set_session(session);
  v1::SessionState response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    return owner.GetState(&context, request, &response);
  }));
  return from_wire(response);
}

static grpc::Status upload_cells(grpc::ClientContext& context, v1::Editing::Stub& stub,
                                 const std::string& session, const std::string& edit_id,
                                 const SetCellFields& change, v1::ApplyResponse& response) {
  const auto writer = stub.UploadCellFields(&context, &response);
  v1::UploadCellFieldsRequest request;
  request.mutable_header()->set_session(session);
  request.mutable_header()->set_edit_id(edit_id);
  request.mutable_header()->set_cells(change.cells.size());
  bool open = writer->Write(request);
  for (size_t sent = 0; open && sent < change.cells.size(); sent += kCellsPerMessage) {
    const size_t count = std::min(kCellsPerMessage, change.cells.size() - sent);
    *request.mutable_cells() = to_wire(change, sent, count);
    open = writer->Write(request);
  }
  writer->WritesDone();
  return writer->Finish();
}

static grpc::Status apply_batch(grpc::ClientContext& context, v1::Editing::Stub& stub,
                                const std::string& session, std::span<const Edit> edits,
                                v1::ApplyResponse& response) {
  v1::ApplyRequest request;
  request.set_session(session);
  for (const Edit& edit : edits) *request.add_edits() = to_wire(edit);
  return stub.Apply(&context, request, &response);
}

static bool is_large(const Edit& edit) {
  const auto* cells = std::get_if<SetCellFields>(&edit.change);
  return cells && cells->cells.size() > kCellsPerMessage;
}

Result<ApplyOutcome> Connection::apply(const std::string& session, std::span<const Edit> edits) {
  // A full path has about 120 kB: so many edits stay well below a message's limit.
  static constexpr std::ptrdiff_t kEditsPerRequest = 16;
  ApplyOutcome total;
  for (auto first = edits.begin(); first != edits.end();) {
    auto last = first;
    while (last != edits.end() && last - first < kEditsPerRequest && !is_large(*last)) ++last;
    const bool is_upload = last == first;
    if (is_upload) ++last;
    v1::ApplyResponse response;
    RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
      if (is_upload)
        return upload_cells(context, owner, session, first->id,
                            std::get<SetCellFields>(first->change), response);
      return apply_batch(context, owner, session, {first, last}, response);
    }));
    const ApplyOutcome outcome = from_wire(response);
    total.applied += outcome.applied;
    total.known += outcome.known;
    total.edits = outcome.edits;
    total.entries.insert(total.entries.end(), outcome.entries.begin(), outcome.entries.end());
    first = last;
  }
  return total;
}

}  // namespace burnish
