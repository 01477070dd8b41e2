#pragma once

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/event_call.h"

namespace burnish {

/// Library.FetchPages: directory blocks and pages, each in an event of its own.
class FetchPagesCall final
    : public EventCall<FetchPagesCall, v1::FetchPagesRequest, v1::FetchPagesEvent> {
 public:
  using EventCall::EventCall;

  Status run();
};

/// Library.FetchSheets: directory blocks, charts and sheets, each in an event of its own.
class FetchSheetsCall final
    : public EventCall<FetchSheetsCall, v1::FetchSheetsRequest, v1::FetchSheetsEvent> {
 public:
  using EventCall::EventCall;

  Status run();
};

}  // namespace burnish
