#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// The rights of a user. Each role may do all that the roles before it may do.
enum class Role {
  kAnyone,  ///< no role at all
  kViewer,  ///< looks
  kEditor,  ///< imports, opens and edits
  kOwner,   ///< deletes scans, and owns every session
};

std::string_view role_name(Role role);

/// Fails: invalid_argument with the choices viewer, editor, owner.
Result<Role> parse_role(const std::string& text);

/// Returns the least role that may call an RPC, e.g. "/burnish.v1.Library/ListScans". Returns
/// nothing if the RPC is not listed: then nobody may call it.
std::optional<Role> least_role(std::string_view method);

/// Returns whether strangers may call an RPC. Such a call says nothing of who makes it.
bool is_open_to_all(std::string_view method);

}  // namespace burnish
