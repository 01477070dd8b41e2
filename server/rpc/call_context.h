#pragma once

#include <grpcpp/grpcpp.h>

#include "common/base/progress.h"
#include "common/wire/status_wire.h"
#include "server/session/executor.h"
#include "server/session/mesh_store.h"
#include "server/session/session_manager.h"

namespace burnish {

/// What every call works with. Reactions run on gRPC's threads and must not block: they post their
/// work to the executor.
struct CallContext {
  MeshStore& store;
  SessionManager& sessions;
  Executor& executor;
};

inline grpc::Status to_grpc(const Status& status) {
  if (status.is_ok()) return grpc::Status::OK;
  return {static_cast<grpc::StatusCode>(status_code_to_wire(status.code())), status.message()};
}

/// Runs `work(progress)` on the executor and ends the unary call with its Status. `progress` says
/// stop once the client has gone. The request and the response live until then.
template <typename Work>
grpc::ServerUnaryReactor* answer(const CallContext& calls, grpc::CallbackServerContext* context,
                                 Work work) {
  grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
  calls.executor.post([reactor, context, work = std::move(work)] {
    const Progress progress = [context](std::string_view, double) {
      return !context->IsCancelled();
    };
    reactor->Finish(to_grpc(work(progress)));
  });
  return reactor;
}

}  // namespace burnish
