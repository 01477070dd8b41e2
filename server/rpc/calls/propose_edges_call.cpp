#include "server/rpc/calls/propose_edges_call.h"

#include "common/wire/library_wire.h"

namespace burnish {

Status ProposeEdgesCall::run() {
  ASSIGN_OR_RETURN(const ScanInfo scan, calls_.store.find(request_.scan()));
  ASSIGN_OR_RETURN(const EdgeProposal proposal, calls_.store.propose_edges(scan.id, progress()));
  v1::ProposeEdgesEvent event;
  *event.mutable_done() = to_wire(proposal);
  events_.push(std::move(event));
  return Status::ok();
}

}  // namespace burnish
