#include "client/connection/connection_state.h"
#include "common/wire/library_wire.h"
#include "common/wire/session_wire.h"

namespace burnish {

Result<ScanInfo> Connection::rename_scan(const std::string& scan, const std::string& name) {
  grpc::ClientContext context;
  state_->set_deadline(context);
  v1::RenameScanRequest request;
  request.set_scan(scan);
  request.set_name(name);
  v1::ScanInfo response;
  RETURN_IF_ERROR(call_status(server(), state_->library->RenameScan(&context, request, &response)));
  return from_wire(response);
}

Result<SessionInfo> Connection::rename_session(const std::string& session,
                                               const std::string& name) {
  v1::RenameSessionRequest request;
  request.set_session(session);
  request.set_name(name);
  v1::SessionInfo response;
  RETURN_IF_ERROR(state_->call_owner([&](v1::Editing::Stub& owner, grpc::ClientContext& context) {
    state_->set_deadline(context);
    return owner.RenameSession(&context, request, &response);
  }));
  return from_wire(response);
}

}  // namespace burnish
