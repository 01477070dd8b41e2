#pragma once

#include <grpcpp/grpcpp.h>

#include "server/session/quota.h"
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

  /// Whose edits a call makes: the user by token or certificate, or where nobody is asked for
  /// those the name that the client gives, which may be "".
  /// Fails: invalid_argument; permission_denied for a name that is another's.
  Result<std::string> caller_of(const grpc::CallbackServerContext& context) const;

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
