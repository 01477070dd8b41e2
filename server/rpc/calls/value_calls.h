#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "burnish/v1/editing.grpc.pb.h"
#include "common/service/page_values.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Editing.GetCells: the present values in chunks. Each chunk waits for the write of the last one.
class GetCellsCall final : public grpc::ServerWriteReactor<v1::Chunk>,
                           public SelfOwned<GetCellsCall> {
 public:
  GetCellsCall(const CallContext& calls, const v1::GetCellsRequest& request);

  void begin();

  void OnWriteDone(bool ok) override;
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  Status take_values();
  void send_next();
  void end(const Status& status) { events_.close(to_grpc(status)); }

  const CallContext calls_;
  const v1::GetCellsRequest request_;
  std::atomic<bool> cancelled_{false};
  std::vector<float> values_;
  size_t sent_bytes_ = 0;
  EventQueue<v1::Chunk> events_;
};

/// Editing.GetPageValues: the present values at the vertices of some pages, an event for each page.
/// Reads some pages at a time, and the next ones after their writes.
class GetPageValuesCall final : public grpc::ServerWriteReactor<v1::PageValues>,
                                public SelfOwned<GetPageValuesCall> {
 public:
  GetPageValuesCall(const CallContext& calls, const v1::GetPageValuesRequest& request);

  void begin();

  void OnWriteDone(bool ok) override;
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override { release(); }

 private:
  void post(Status (GetPageValuesCall::*work)());
  Status send_first();
  Status send_some();
  void end(const Status& status) { events_.close(to_grpc(status)); }

  const CallContext calls_;
  const v1::GetPageValuesRequest request_;
  std::atomic<bool> cancelled_{false};
  // Used by the one piece of work under way only.
  std::shared_ptr<const SharedMesh> mesh_;
  std::shared_ptr<const ScanPages> scan_;
  std::vector<PageId> pages_;
  std::vector<float> values_;  // one per cell
  size_t sent_ = 0;            // pages
  std::atomic<size_t> unwritten_{0};
  EventQueue<v1::PageValues> events_;
};

}  // namespace burnish
