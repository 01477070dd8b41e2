#include "server/rpc/calls/prepare_call.h"

#include "common/wire/format_wire.h"
#include "common/wire/library_wire.h"

namespace burnish {

Status PrepareCall::run() {
  ASSIGN_OR_RETURN(const PreparedKey key,
                   prepared_key_from_wire(request_.depth(), request_.curvature_radius()));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  RETURN_IF_ERROR(calls_.store.prepare_scan(scan.id, resolve(key, scan), progress(), calls_.user));
  ASSIGN_OR_RETURN(const ScanInfo prepared, calls_.store.find(scan.id));
  v1::PrepareEvent event;
  *event.mutable_done() = to_wire(prepared);
  events_.push(std::move(event));
  return Status::ok();
}

}  // namespace burnish
