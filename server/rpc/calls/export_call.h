#pragma once

#include <memory>

#include "burnish/v1/editing.grpc.pb.h"
#include "server/rpc/reactor/event_call.h"

namespace burnish {

/// Editing.Export: progress while the session solves, then the file, then the summary. Each chunk
/// waits for the write of the last one, so a slow client holds no thread.
class ExportCall final : public EventCall<ExportCall, v1::ExportRequest, v1::ExportEvent> {
 public:
  using EventCall::EventCall;

  void begin();

  void OnWriteDone(bool ok) override;

 private:
  Status solve();
  void send_next();

  std::unique_ptr<ExportFile> file_;
  uint64_t sent_bytes_ = 0;
};

}  // namespace burnish
