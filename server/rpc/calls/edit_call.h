#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include "burnish/v1/editing.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/live_writer.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Editing.Edit: a greeting, which brings the session back on the executor. Then it passes the
/// client's messages on at once, because none of them waits, and the writer sends the answers.
class EditCall final : public grpc::ServerBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer>,
                       public SelfOwned<EditCall> {
 public:
  EditCall(const CallContext& calls, grpc::CallbackServerContext& context);

  void begin() { StartRead(&received_); }

  void OnReadDone(bool ok) override;
  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  void write(const v1::ServerMessage& message);
  void take_message(bool ok);
  void take_greeting();
  Result<LiveClient> join();
  void take_slot(const LiveClient& client);
  void cut();

  void refuse(const Status& status);
  void end_of_requests();
  Status take_request();
  Status take(const Greeting& greeting);
  Status take(const FrameCredit& credit);
  Status take(ApplyEdits& apply);
  Status take(Preview& piece);
  Status take(const DropPreview& drop);
  Status take(const MoveBrush& move);
  Status take(const Heartbeat& beat);
  Status take(const ShowPages& change);
  uint64_t connection() const { return client_->subscriber->connection; }
  void read_on();

  const CallContext calls_;
  grpc::CallbackServerContext& context_;
  std::atomic<bool> cancelled_{false};
  grpc::ByteBuffer received_, sent_;
  v1::ClientMessage request_;  // received message
  std::atomic<bool> reading_paused_{false};
  LiveWriter writer_;

  std::mutex mutex_;  // guards the following members
  std::optional<LiveClient> client_;
  bool done_ = false;
};

}  // namespace burnish
