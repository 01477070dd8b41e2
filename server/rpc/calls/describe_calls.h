#pragma once

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/event_call.h"

namespace burnish {

/// Library.DescribePages: progress while the store makes the pages, then their head.
class DescribePagesCall final
    : public EventCall<DescribePagesCall, v1::DescribePagesRequest, v1::DescribePagesEvent> {
 public:
  using EventCall::EventCall;

  Status run();
};

/// Library.DescribeSheets: progress while the store makes the sheets, then their head. A session
/// says how its seams are levelled.
class DescribeSheetsCall final
    : public EventCall<DescribeSheetsCall, v1::DescribeSheetsRequest, v1::DescribeSheetsEvent> {
 public:
  using EventCall::EventCall;

  Status run();
};

}  // namespace burnish
