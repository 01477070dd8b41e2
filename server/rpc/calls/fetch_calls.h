#pragma once

#include <atomic>

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Library.FetchPages: directory blocks and pages, each in an event of its own.
class FetchPagesCall final : public grpc::ServerWriteReactor<v1::FetchPagesEvent>,
                             public SelfOwned<FetchPagesCall> {
 public:
  FetchPagesCall(const CallContext& calls, const v1::FetchPagesRequest& request);

  void begin();

  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status send();
  void end(const Status& status) { events_.close(to_grpc(status)); }

  const CallContext calls_;
  const v1::FetchPagesRequest request_;
  std::atomic<bool> cancelled_{false};
  EventQueue<v1::FetchPagesEvent> events_;
};

/// Library.FetchSheets: directory blocks, charts and sheets, each in an event of its own.
class FetchSheetsCall final : public grpc::ServerWriteReactor<v1::FetchSheetsEvent>,
                              public SelfOwned<FetchSheetsCall> {
 public:
  FetchSheetsCall(const CallContext& calls, const v1::FetchSheetsRequest& request);

  void begin();

  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status send();
  void end(const Status& status) { events_.close(to_grpc(status)); }

  const CallContext calls_;
  const v1::FetchSheetsRequest request_;
  std::atomic<bool> cancelled_{false};
  EventQueue<v1::FetchSheetsEvent> events_;
};

}  // namespace burnish
