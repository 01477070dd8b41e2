#pragma once

#include <grpcpp/grpcpp.h>

#include "common/base/progress.h"
#include "server/library/mesh_store.h"
#include "server/live/live_sessions.h"
#include "server/manager/session_manager.h"
#include "server/rpc/admission/call_guard.h"
#include "server/rpc/reactor/call_executor.h"
#include "server/rpc/reactor/references.h"
#include "server/rpc/transport/to_grpc.h"

namespace burnish {

/// The context of every call. Reactions run on gRPC's threads and must not block: they post their
/// work to the executor.
struct CallContext {
  MeshStore& store;
  SessionManager& sessions;
  LiveSessions& live;
  CallExecutor executor;
  CallGuard& guard;
  std::chrono::seconds upload_silence_max;  ///< for a client that announced more data
  std::string user = {};                    ///< the caller; empty without authentication
  Caller caller = {};                       ///< the caller at sessions, for a call that lasts
  std::function<Status()> may_stay = {};    ///< likewise; empty: always
  std::shared_ptr<const Quota::Share> stream = {};  ///< part of the user's limit
};

/// Runs `work(progress)` in the call's pool and ends the unary call with its Status, or with the
/// reason why it could not run. `progress` says stop when the client is gone. The request and the
/// response live until then.
template <typename Request, typename Work>
grpc::ServerUnaryReactor* answer(const CallContext& calls, grpc::CallbackServerContext* context,
                                 const Request& request, Work work) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  const auto end = [reactor](const Status& status) { reactor->Finish(to_grpc(status)); };
  const auto caller = calls.guard.identify(*context);
  const Status status = caller.is_ok() ? check_references(request) : caller.status();
  if (!status.is_ok()) {
    end(status);
    return reactor;
  }
  const auto run = [end, context, work = std::move(work)] {
    const Progress progress = [context](std::string_view, double) {
      return !context->IsCancelled();
    };
    end(work(progress));
  };
  calls.executor.for_call(*context, caller.value().user).post(run, end, request.SpaceUsedLong());
  return reactor;
}

}  // namespace burnish
