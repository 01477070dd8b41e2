#pragma once

#include <utility>

#include "server/rpc/reactor/call_context.h"

namespace burnish {

/// A streaming call that ends at once.
template <typename Reactor>
class RefusedCall final : public Reactor {
 public:
  explicit RefusedCall(grpc::Status status) { this->Finish(std::move(status)); }
  void OnDone() override { delete this; }
};

/// gRPC's base class of a streaming call.
template <typename Request, typename Response>
grpc::ServerBidiReactor<Request, Response> reactor_of(
    const grpc::ServerBidiReactor<Request, Response>*);
template <typename Request>
grpc::ServerReadReactor<Request> reactor_of(const grpc::ServerReadReactor<Request>*);
template <typename Response>
grpc::ServerWriteReactor<Response> reactor_of(const grpc::ServerWriteReactor<Response>*);
template <typename Call>
using ReactorOf = decltype(reactor_of(static_cast<const Call*>(nullptr)));

/// Lets a streaming call in and starts it with its own CallContext, or ends it at once.
template <typename Call, typename... Arguments>
ReactorOf<Call>* start_call(const CallContext& calls, grpc::CallbackServerContext* context,
                            Arguments&&... arguments) {
  auto admitted = calls.guard.admit_stream(*context);
  if (!admitted.is_ok()) return new RefusedCall<ReactorOf<Call>>(to_grpc(admitted.status()));
  Status named;
  ((named = named.is_ok() ? check_references(arguments) : named), ...);
  if (!named.is_ok()) return new RefusedCall<ReactorOf<Call>>(to_grpc(named));
  auto caller = calls.guard.caller_of(*context);
  if (!caller.is_ok()) return new RefusedCall<ReactorOf<Call>>(to_grpc(caller.status()));
  CallContext own = calls;
  own.caller = std::move(caller).value();
  own.may_stay = calls.guard.may_stay(*context, admitted.value().identity);
  own.executor = calls.executor.for_call(*context, admitted.value().identity.user);
  own.user = admitted.value().identity.user;
  own.stream = std::make_shared<const Quota::Share>(std::move(admitted.value().share));
  return Call::start(own, std::forward<Arguments>(arguments)...);
}

}  // namespace burnish
