#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "common/base/status.h"
#include "common/service/session_roles.h"

namespace burnish {

/// Who asks for something of a session, and the most that the server lets them be there.
struct Caller {
  // A name alone is a caller whom the server does not bound.
  Caller(std::string name = {}) : user(std::move(name)) {}  // NOLINT(google-explicit-constructor)
  Caller(const char* name) : user(name) {}                  // NOLINT(google-explicit-constructor)

  std::string user;                        ///< "": somebody without a name
  SessionRole most = SessionRole::kOwner;  ///< whatever the session's roles say
  bool owns_server = false;                ///< an owner of every session

  bool operator==(const Caller&) const = default;
};

/// What the caller may do in a session with these roles.
SessionRole role_in(const SessionRoles& roles, const Caller& caller);

/// Fails: permission_denied naming the caller, the role, and the one that `what` needs.
Status require_role(const SessionRoles& roles, const Caller& caller, SessionRole least,
                    std::string_view what);

}  // namespace burnish
