#pragma once

#include <atomic>

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Library.DescribePages: progress while the store makes the pages, then their head.
class DescribePagesCall final : public grpc::ServerWriteReactor<v1::DescribePagesEvent>,
                                public SelfOwned<DescribePagesCall> {
 public:
  DescribePagesCall(const CallContext& calls, const v1::DescribePagesRequest& request);

  void begin();

  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status describe();
  void end(const Status& status) { events_.close(to_grpc(status)); }
  bool report_progress(std::string_view phase, double fraction);

  const CallContext calls_;
  const v1::DescribePagesRequest request_;
  std::atomic<bool> cancelled_{false};
  EventQueue<v1::DescribePagesEvent> events_;
};

/// Library.DescribeSheets: progress while the store makes the sheets, then their head. A session
/// says how its seams are levelled.
class DescribeSheetsCall final : public grpc::ServerWriteReactor<v1::DescribeSheetsEvent>,
                                 public SelfOwned<DescribeSheetsCall> {
 public:
  DescribeSheetsCall(const CallContext& calls, const v1::DescribeSheetsRequest& request);

  void begin();

  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status describe();
  void end(const Status& status) { events_.close(to_grpc(status)); }
  bool report_progress(std::string_view phase, double fraction);

  const CallContext calls_;
  const v1::DescribeSheetsRequest request_;
  std::atomic<bool> cancelled_{false};
  EventQueue<v1::DescribeSheetsEvent> events_;
};

}  // namespace burnish
