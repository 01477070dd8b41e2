#pragma once

#include <functional>

#include <grpcpp/grpcpp.h>

#include "server/manager/caller.h"
#include "server/memory/quota.h"
#include "server/trust/guard.h"

namespace burnish {

/// Who makes a call that Admission has let in, and how many streams has he already. Every refusal
/// is logged with peer, method and reason, and counted. Thread-safe.
class CallGuard {
 public:
  /// Needs: `guard` outlives it.
  CallGuard(const Guard& guard, uint64_t streams_per_user)
      : guard_(guard), streams_("streams", "limits.streams_per_user", streams_per_user) {}

  /// Fails as Guard::identify(): the users may have changed since the call was let in.
  Result<Identity> identify(const grpc::CallbackServerContext& context) const;

  /// Who works at sessions by this call: the user by token or certificate, with what the server
  /// lets them do; or where nobody is asked for those, the name that the client gives, which may
  /// be "". Fails: invalid_argument; permission_denied for a name that is another's.
  Result<Caller> caller_of(const grpc::CallbackServerContext& context) const;

  /// For calls that last: tells whether the caller would still be let in, as who they were then.
  /// Outlives the call's context. Empty where nobody is asked who they are.
  std::function<Status()> may_stay(const grpc::CallbackServerContext& context,
                                   const Identity& identity) const;

  /// The same as identify() for a call that lasts; the share is the user's part of the limit.
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
