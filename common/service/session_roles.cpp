#include "common/service/session_roles.h"

#include <algorithm>

namespace burnish {

const char* session_role_name(SessionRole role) {
  switch (role) {
    case SessionRole::kViewer:
      return "viewer";
    case SessionRole::kEditor:
      return "editor";
    case SessionRole::kOwner:
      return "owner";
  }
  return "?";
}

SessionRoles SessionRoles::of_new_session(const std::string& maker) {
  if (maker.empty()) return SessionRoles();
  return SessionRoles({{"", SessionRole::kEditor}, {maker, SessionRole::kOwner}});
}

SessionRole SessionRoles::of(const std::string& user) const {
  const auto own = roles_.find(user);
  if (own != roles_.end()) return own->second;
  const auto others = roles_.find("");
  return others == roles_.end() ? SessionRole::kViewer : others->second;
}

Status SessionRoles::set(const std::string& user, SessionRole role) {
  std::map<std::string, SessionRole> changed = roles_;
  changed[user] = role;
  if (std::none_of(changed.begin(), changed.end(),
                   [](const auto& entry) { return entry.second == SessionRole::kOwner; }))
    return failed_precondition(
        "a session needs at least one owner; make somebody else an owner first");
  roles_ = std::move(changed);
  return Status::ok();
}

}  // namespace burnish
