#include "server/rpc/calls/prepare_call.h"

#include "common/wire/format_wire.h"
#include "common/wire/library_wire.h"

namespace burnish {

PrepareCall::PrepareCall(const CallContext& calls, const v1::PrepareScanRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::PrepareEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void PrepareCall::begin() {
  calls_.executor.post(
      [call = self()] {
        const auto scan = call->prepare();
        if (scan.is_ok()) {
          v1::PrepareEvent event;
          *event.mutable_done() = to_wire(scan.value());
          call->events_.push(std::move(event));
        }
        call->end(scan.status());
      },
      [call = self()](const Status& status) { call->end(status); });
}

Result<ScanInfo> PrepareCall::prepare() {
  ASSIGN_OR_RETURN(const PreparedKey key,
                   prepared_key_from_wire(request_.depth(), request_.curvature_radius()));
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  const Progress progress = [this](std::string_view phase, double fraction) {
    return report_progress(phase, fraction);
  };
  RETURN_IF_ERROR(calls_.store.prepare_scan(
      scan.id, resolve(key, scan), give_way_to(calls_.live.scheduler(), progress), calls_.user));
  return calls_.store.find(scan.id);
}

bool PrepareCall::report_progress(std::string_view phase, double fraction) {
  v1::PrepareEvent event;
  event.mutable_progress()->set_phase(std::string(phase));
  event.mutable_progress()->set_fraction(fraction);
  events_.offer(std::move(event));
  return !cancelled_;
}

}  // namespace burnish
