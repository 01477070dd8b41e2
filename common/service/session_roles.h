#pragma once

#include <map>
#include <string>

#include "common/base/status.h"

namespace burnish {

/// The rights of a person in a session; each role may do what those before it may.
enum class SessionRole {
  kViewer = 1,  ///< look, export, fork
  kEditor = 2,  ///< edit
  kOwner = 3,   ///< give roles, delete the session
};

/// "viewer", "editor", "owner".
const char* session_role_name(SessionRole role);

/// Who may do what in one session. The name "" stands for everybody who has no role of their own.
class SessionRoles {
 public:
  /// Everybody is an owner: nobody is known by name.
  SessionRoles() = default;
  explicit SessionRoles(std::map<std::string, SessionRole> roles) : roles_(std::move(roles)) {}

  /// Returns those of a new session: its maker is the owner, everybody else an editor. A maker
  /// without a name cannot be told from others: everybody is an owner then.
  static SessionRoles of_new_session(const std::string& maker);

  SessionRole of(const std::string& user) const;

  /// Fails: failed_precondition when nobody would be left as an owner.
  Status set(const std::string& user, SessionRole role);

  const std::map<std::string, SessionRole>& by_user() const { return roles_; }

 private:
  std::map<std::string, SessionRole> roles_ = {{"", SessionRole::kOwner}};
};

}  // namespace burnish
