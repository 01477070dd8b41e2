#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "common/base/status.h"
#include "common/service/session_roles.h"

namespace burnish {

/// Who asks for something of a session, and the highest role that the server allows them there.
struct Caller {
  // The server does not bound a caller who is only a name.
  Caller(std::string name = {}) : user(std::move(name)) {}  // NOLINT(google-explicit-constructor)
  Caller(const char* name) : user(name) {}                  // NOLINT(google-explicit-constructor)

  std::string user;                        ///< "": somebody without a name
  SessionRole most = SessionRole::kOwner;  ///< bounds the session's roles
  bool owns_server = false;                ///< owns every session
  bool is_admitted = false;                ///< the server has users, and knows this one

  /// Returns whether the limits of one user's kept sessions and histories hold for the caller. An
  /// owner of the server has none, and somebody who is only a name cannot be told from others.
  bool has_share() const { return is_admitted && !owns_server; }

  bool operator==(const Caller&) const = default;
};

/// Returns the caller's role in a session with these roles.
SessionRole role_in(const SessionRoles& roles, const Caller& caller);

/// Fails: permission_denied that names the caller, the role, and the role that `what` needs.
Status require_role(const SessionRoles& roles, const Caller& caller, SessionRole least,
                    std::string_view what);

}  // namespace burnish
