#pragma once

#include <grpcpp/grpcpp.h>

#include "server/process/log_context.h"
#include "server/scheduling/pools.h"

namespace burnish {

/// The workers for one call: its work runs in the call's pool, in its caller's turn, and logs under
/// its request id.
class CallExecutor {
 public:
  explicit CallExecutor(Pools& pools) : pools_(&pools) {}

  /// For a call of `user`, or of its address without authentication.
  CallExecutor for_call(const grpc::CallbackServerContext& context, const std::string& user) const;

  /// Runs `work`. `on_failure` gets the reason if it cannot run or end, perhaps at once: the
  /// caller's queue is full, or memory has run out. `bytes`: size of the message that the work
  /// holds.
  void post(std::function<void()> work, std::function<void(const Status&)> on_failure,
            uint64_t bytes = 0) const {
    post(pool_, std::move(work), std::move(on_failure), bytes);
  }

  /// Does the same in another pool than the call's.
  void post(Pool pool, std::function<void()> work, std::function<void(const Status&)> on_failure,
            uint64_t bytes = 0) const {
    const LogContext context(request_id_);
    (*pools_)[pool].post({std::move(work), std::move(on_failure), holder_, bytes});
  }

 private:
  Pools* pools_;
  Pool pool_ = Pool::kSession;
  std::string holder_;
  std::string request_id_;
};

}  // namespace burnish
