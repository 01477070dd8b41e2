#pragma once

#include <atomic>
#include <memory>

#include "burnish/v1/editing.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Editing.Export: progress while the session solves, then the file, then the summary. Each chunk
/// waits for the write of the last one, so a slow client holds no thread.
class ExportCall final : public grpc::ServerWriteReactor<v1::ExportEvent>,
                         public SelfOwned<ExportCall> {
 public:
  ExportCall(const CallContext& calls, const v1::ExportRequest& request);

  void begin();

  void OnWriteDone(bool ok) override;
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status solve();
  void send_next();
  void end(const Status& status) { events_.close(to_grpc(status)); }
  bool report_progress(std::string_view phase, double fraction);

  const CallContext calls_;
  const v1::ExportRequest request_;
  std::atomic<bool> cancelled_{false};
  std::unique_ptr<ExportFile> file_;
  uint64_t sent_bytes_ = 0;
  EventQueue<v1::ExportEvent> events_;
};

}  // namespace burnish
