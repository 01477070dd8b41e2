#include "client/connection/connection_state.h"
#include "common/wire/status_wire.h"

namespace burnish {

Status call_status(const std::string& server, const grpc::Status& status) {
  if (status.ok()) return Status::ok();
  const std::string where = "server " + server + ": ";
  const StatusCode code = status_code_from_wire(status.error_code());
  if (code == StatusCode::kDeadlineExceeded) return {code, where + "no answer in time"};
  if (code == StatusCode::kUnavailable)
    return {code, where + "the connection is lost (" + status.error_message() + ")"};
  return {code, where + status.error_message()};
}

}  // namespace burnish
