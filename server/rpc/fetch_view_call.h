#pragma once

#include <atomic>
#include <memory>

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/call_context.h"
#include "server/rpc/event_queue.h"
#include "server/rpc/self_owned.h"

namespace burnish {

/// Library.FetchView: progress while the view is made, its header, then its chunks. Each chunk
/// waits for the write of the last one. All clients of a view share its bytes.
class FetchViewCall final : public grpc::ServerWriteReactor<v1::FetchViewEvent>,
                            public SelfOwned<FetchViewCall> {
 public:
  FetchViewCall(const CallContext& calls, const v1::FetchViewRequest& request);

  void begin();

  void OnWriteDone(bool ok) override;
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status open();
  void send_header();
  void send_next();
  void end(const Status& status) { events_.close(to_grpc(status)); }
  bool report_progress(std::string_view phase, double fraction);

  const CallContext calls_;
  const v1::FetchViewRequest request_;
  std::atomic<bool> cancelled_{false};
  std::shared_ptr<const PackedView> view_;
  size_t sent_bytes_ = 0;
  EventQueue<v1::FetchViewEvent> events_;
};

}  // namespace burnish
