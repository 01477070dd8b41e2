#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "burnish/v1/editing.grpc.pb.h"
#include "common/service/page_values.h"
#include "server/rpc/reactor/event_call.h"

namespace burnish {

/// Editing.GetCells: the present values in chunks. Each chunk waits for the write of the last one.
class GetCellsCall final : public EventCall<GetCellsCall, v1::GetCellsRequest, v1::Chunk> {
 public:
  using EventCall::EventCall;

  void begin();

  void OnWriteDone(bool ok) override;

 private:
  Status take_values();
  void send_next();

  std::vector<float> values_;
  size_t sent_bytes_ = 0;
};

/// Editing.GetPageValues: the present values at the vertices of some pages, an event for each page.
/// Reads some pages at a time, and the next ones after their writes.
class GetPageValuesCall final
    : public EventCall<GetPageValuesCall, v1::GetPageValuesRequest, v1::PageValues> {
 public:
  using EventCall::EventCall;

  void begin();

  void OnWriteDone(bool ok) override;

 private:
  void send(Status (GetPageValuesCall::*work)());
  Status send_first();
  Status send_some();

  // Used by the one piece of work under way only.
  std::shared_ptr<const SharedMesh> mesh_;
  std::shared_ptr<const ScanPages> scan_;
  std::vector<PageId> pages_;
  std::vector<float> values_;  // one per cell
  size_t sent_ = 0;            // pages
  std::atomic<size_t> unwritten_{0};
};

}  // namespace burnish
