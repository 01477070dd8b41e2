#pragma once

#include <atomic>
#include <mutex>
#include <optional>

#include <grpcpp/alarm.h>

#include "burnish/v1/editing.grpc.pb.h"
#include "server/rpc/reactor/call_context.h"
#include "server/rpc/reactor/live_writer.h"
#include "server/rpc/reactor/self_owned.h"

namespace burnish {

/// Editing.Watch: a client of a live session that cannot speak. It gets a credit for a key frame
/// after the write of the last one, and at least kFrameInterval after that.
class WatchCall final : public grpc::ServerWriteReactor<v1::ServerMessage>,
                        public SelfOwned<WatchCall> {
 public:
  WatchCall(const CallContext& calls, grpc::CallbackServerContext& context,
            const v1::WatchRequest& request);

  void begin();

  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  Result<LiveClient> join();
  Status show_pages(const LiveClient& client) const;
  void take_slot(const LiveClient& client);
  void grant_later();
  void cut();

  const CallContext calls_;
  grpc::CallbackServerContext& context_;
  const v1::WatchRequest request_;
  std::atomic<bool> cancelled_{false};
  LiveWriter writer_;

  std::mutex mutex_;  // guards the following members
  std::optional<LiveClient> client_;
  grpc::Alarm next_frame_;
  bool done_ = false;
};

}  // namespace burnish
