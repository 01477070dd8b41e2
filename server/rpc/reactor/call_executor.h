#pragma once

#include <grpcpp/grpcpp.h>

#include "server/process/log_context.h"
#include "server/scheduling/lanes.h"

namespace burnish {

/// The workers for one call: its work runs in the call's lane, in its caller's turn, and logs under
/// its request id.
class CallExecutor {
 public:
  explicit CallExecutor(Lanes& lanes) : lanes_(&lanes) {}

  /// For a call of `user`, or of its address without authentication.
  CallExecutor for_call(const grpc::CallbackServerContext& context, const std::string& user) const;

  /// Runs `work`. `on_failure` gets the reason if it cannot run or end, perhaps at once: the
  /// caller's queue is full, or memory has run out. `bytes`: size of the message that the work
  /// holds.
  void post(std::function<void()> work, std::function<void(const Status&)> on_failure,
            uint64_t bytes = 0) const {
    post(lane_, std::move(work), std::move(on_failure), bytes);
  }

  /// Does the same in another lane than the call's.
  void post(Lane lane, std::function<void()> work, std::function<void(const Status&)> on_failure,
            uint64_t bytes = 0) const {
    const LogContext context(request_id_);
    (*lanes_)[lane].post({std::move(work), std::move(on_failure), holder_, bytes});
  }

 private:
  Lanes* lanes_;
  Lane lane_ = Lane::kSession;
  std::string holder_;
  std::string request_id_;
};

}  // namespace burnish
