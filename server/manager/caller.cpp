#include "server/manager/caller.h"

#include <algorithm>

namespace burnish {

SessionRole role_in(const SessionRoles& roles, const Caller& caller) {
  if (caller.owns_server) return SessionRole::kOwner;
  return std::min(roles.of(caller.user), caller.most);
}

Status require_role(const SessionRoles& roles, const Caller& caller, SessionRole least,
                    std::string_view what) {
  const SessionRole role = role_in(roles, caller);
  if (role >= least) return Status::ok();
  const bool is_bounded = roles.of(caller.user) > caller.most;
  return {StatusCode::kPermissionDenied,
          std::string(what) + " needs the role " + session_role_name(least) + "; " +
              (caller.user.empty() ? "somebody without a name" : "'" + caller.user + "'") + " is " +
              session_role_name(role) + " of this " + (is_bounded ? "server" : "session")};
}

}  // namespace burnish
