#pragma once

#include <atomic>
#include <vector>

#include "burnish/v1/editing.grpc.pb.h"
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

}  // namespace burnish
