#include "server/rpc/reactor/call_executor.h"

#include "server/rpc/admission/call_observer.h"
#include "server/rpc/reactor/call_pools.h"

namespace burnish {

/// Returns "ipv4:127.0.0.1" for "ipv4:127.0.0.1:5000": all connections of an address are one
/// holder.
static std::string host_of(const std::string& peer) {
  return peer.starts_with("ipv") ? peer.substr(0, peer.rfind(':')) : peer;
}

CallExecutor CallExecutor::for_call(const grpc::CallbackServerContext& context,
                                    const std::string& user) const {
  CallExecutor own = *this;
  own.pool_ = pool_of(method_of(context));
  own.holder_ = user.empty() ? host_of(peer_of(context)) : "user " + user;
  own.request_id_ = request_id_of(context);
  return own;
}

}  // namespace burnish
