#pragma once

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/event_call.h"

namespace burnish {

/// Library.ProposeEdges: progress while the store measures the scan, then what it proposes.
class ProposeEdgesCall final
    : public EventCall<ProposeEdgesCall, v1::ProposeEdgesRequest, v1::ProposeEdgesEvent> {
 public:
  using EventCall::EventCall;

  Status run();
};

}  // namespace burnish
