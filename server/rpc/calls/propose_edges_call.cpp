#include "server/rpc/calls/propose_edges_call.h"

#include "common/wire/library_wire.h"

namespace burnish {

ProposeEdgesCall::ProposeEdgesCall(const CallContext& calls, const v1::ProposeEdgesRequest& request)
    : calls_(calls),
      request_(request),
      events_([this](const v1::ProposeEdgesEvent* event) { StartWrite(event); },
              [this](grpc::Status status) { Finish(std::move(status)); }) {}

void ProposeEdgesCall::begin() {
  calls_.executor.post([call = self()] { call->end(call->propose()); },
                       [call = self()](const Status& status) { call->end(status); });
}

Status ProposeEdgesCall::propose() {
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  const Progress progress = [this](std::string_view phase, double fraction) {
    return report_progress(phase, fraction);
  };
  ASSIGN_OR_RETURN(
      const EdgeProposal proposal,
      calls_.store.propose_edges(scan.id, give_way_to(calls_.live.scheduler(), progress)));
  v1::ProposeEdgesEvent event;
  *event.mutable_done() = to_wire(proposal);
  events_.push(std::move(event));
  return Status::ok();
}

bool ProposeEdgesCall::report_progress(std::string_view phase, double fraction) {
  v1::ProposeEdgesEvent event;
  event.mutable_progress()->set_phase(std::string(phase));
  event.mutable_progress()->set_fraction(fraction);
  events_.offer(std::move(event));
  return !cancelled_;
}

}  // namespace burnish
