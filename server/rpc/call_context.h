#pragma once

#include <grpcpp/grpcpp.h>

#include "common/base/progress.h"
#include "common/wire/status_wire.h"
#include "server/process/log_context.h"
#include "server/rpc/call_guard.h"
#include "server/rpc/call_observer.h"
#include "server/session/executor.h"
#include "server/session/live_sessions.h"
#include "server/session/mesh_store.h"
#include "server/session/session_manager.h"

namespace burnish {

/// The executor for one call: its work logs under the call's request id.
class CallExecutor {
 public:
  explicit CallExecutor(Executor& executor, std::string request_id = {})
      : executor_(&executor), request_id_(std::move(request_id)) {}

  CallExecutor for_request(std::string request_id) const {
    return CallExecutor(*executor_, std::move(request_id));
  }

  void post(std::function<void()> work) const {
    const LogContext context(request_id_);
    executor_->post(std::move(work));
  }

 private:
  Executor* executor_;
  std::string request_id_;
};

/// What every call works with. Reactions run on gRPC's threads and must not block: they post their
/// work to the executor.
struct CallContext {
  MeshStore& store;
  SessionManager& sessions;
  LiveSessions& live;
  CallExecutor executor;
  CallGuard& guard;
  std::string user = {};                            ///< who calls; empty: nobody was asked
  Caller caller = {};                               ///< of a call that lasts, at sessions
  std::function<Status()> may_stay = {};            ///< likewise; empty: for ever
  std::shared_ptr<const Quota::Share> stream = {};  ///< his share of the streams, while they last
};

inline grpc::Status to_grpc(const Status& status) {
  if (status.is_ok()) return grpc::Status::OK;
  return {static_cast<grpc::StatusCode>(status_code_to_wire(status.code())), status.message()};
}

/// Lets the call in, runs `work(progress)` on the executor and ends the unary call with its Status.
/// `progress` says stop once the client has gone. The request and the response live until then.
template <typename Work>
grpc::ServerUnaryReactor* answer(const CallContext& calls, grpc::CallbackServerContext* context,
                                 Work work) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  const Status admitted = calls.guard.admit(*context).status();
  if (!admitted.is_ok()) {
    reactor->Finish(to_grpc(admitted));
    return reactor;
  }
  const auto run = [reactor, context, work = std::move(work)] {
    const Progress progress = [context](std::string_view, double) {
      return !context->IsCancelled();
    };
    reactor->Finish(to_grpc(work(progress)));
  };
  calls.executor.for_request(request_id_of(*context)).post(run);
  return reactor;
}

}  // namespace burnish
