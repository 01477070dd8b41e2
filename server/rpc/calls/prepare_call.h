#pragma once

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/event_call.h"

namespace burnish {

/// Library.PrepareScan: progress while the store prepares, then the scan.
class PrepareCall final : public EventCall<PrepareCall, v1::PrepareScanRequest, v1::PrepareEvent> {
 public:
  using EventCall::EventCall;

  Status run();
};

}  // namespace burnish
