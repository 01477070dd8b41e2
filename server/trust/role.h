#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// What somebody may do; each role may do all that the ones before it may.
enum class Role {
  kAnyone,  ///< no role at all
  kViewer,  ///< looks
  kEditor,  ///< imports, opens and edits
  kOwner,   ///< deletes scans, and owns every session
};

std::string_view role_name(Role role);

/// Fails: invalid_argument with the choices viewer, editor, owner.
Result<Role> parse_role(const std::string& text);

/// The least role that may call an RPC, e.g. "/burnish.v1.Library/ListScans".
/// Nothing: the RPC is in no table, and nobody may.
std::optional<Role> least_role(std::string_view method);

}  // namespace burnish
