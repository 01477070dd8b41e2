#pragma once

#include <functional>

#include <grpcpp/grpcpp.h>

#include "server/manager/caller.h"
#include "server/memory/quota.h"
#include "server/trust/guard.h"

namespace burnish {

/// Says who makes an admitted call, and limits their streams. Logs every refusal with peer, method
/// and reason, and counts it. Thread-safe.
class CallGuard {
 public:
  /// Needs: `guard` outlives it.
  CallGuard(const Guard& guard, uint64_t streams_per_user)
      : guard_(guard), streams_("streams", "limits.streams_per_user", streams_per_user) {}

  /// Fails: as Guard::identify(), because the users may have changed since the call was admitted.
  Result<Identity> identify(const grpc::CallbackServerContext& context) const;

  /// Returns the caller of sessions in this call. With authentication it is the user of the token
  /// or certificate, with the server's bounds. Without, it is the name that the client gives, which
  /// may be "". Fails: invalid_argument; permission_denied for another user's name.
  Result<Caller> caller_of(const grpc::CallbackServerContext& context) const;

  /// For calls that last: returns a function that says whether the caller would still be let in
  /// with the same identity. It outlives the call's context. Empty without authentication.
  std::function<Status()> may_stay(const grpc::CallbackServerContext& context,
                                   const Identity& identity) const;

  /// The result of identify() for a call that lasts; the share is its part of the user's limit.
  struct Stream {
    Identity identity;
    Quota::Share share;
  };
  Result<Stream> admit_stream(const grpc::CallbackServerContext& context);

 private:
  const Guard& guard_;
  Quota streams_;
};

}  // namespace burnish
