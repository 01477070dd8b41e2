#pragma once

#include <atomic>

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Library.PrepareScan: progress while the store prepares, then the scan.
class PrepareCall final : public grpc::ServerWriteReactor<v1::PrepareEvent>,
                          public SelfOwned<PrepareCall> {
 public:
  PrepareCall(const CallContext& calls, const v1::PrepareScanRequest& request);

  void begin();

  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Result<ScanInfo> prepare();
  void end(const Status& status) { events_.close(to_grpc(status)); }
  bool report_progress(std::string_view phase, double fraction);

  const CallContext calls_;
  const v1::PrepareScanRequest request_;
  std::atomic<bool> cancelled_{false};
  EventQueue<v1::PrepareEvent> events_;
};

}  // namespace burnish
