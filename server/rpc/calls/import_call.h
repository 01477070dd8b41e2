#pragma once

#include <atomic>
#include <memory>

#include "burnish/v1/library.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/event_queue.h"
#include "server/rpc/reactor/self_owned.h"
#include "server/rpc/reactor/silence_limit.h"

namespace burnish {

/// Library.Import: header, chunks, then the work of the store. Reads one message at a time, and the
/// next only after the last is on its way to disk. Refuses a client that announces a file and is
/// silent for too long.
class ImportCall final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>,
                         public SelfOwned<ImportCall> {
 public:
  explicit ImportCall(const CallContext& calls);

  void begin();

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override { events_.on_write_done(ok); }
  void OnCancel() override { cancelled_ = true; }
  void OnDone() override {
    silence_.stop();
    release();
  }

 private:
  void read_next();
  std::function<void(const Status&)> failing();
  Status take_request();
  Status take_header(const v1::ImportHeader& message);
  Status take_chunk(const v1::Chunk& chunk);
  void look_for_known();
  void ask_for_chunks();
  void write(const v1::ImportEvent& event);
  void end_of_requests();
  void end(const Result<ImportOutcome>& outcome);
  Progress progress();

  const CallContext calls_;
  std::atomic<bool> cancelled_{false};
  grpc::ByteBuffer received_, sent_;
  v1::ImportRequest request_;  // received message
  ImportHeader header_;
  std::unique_ptr<Upload> upload_;
  SilenceLimit silence_;
  EventQueue<v1::ImportEvent> events_;
};

}  // namespace burnish
