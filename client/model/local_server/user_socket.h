#pragma once

#include <filesystem>

#include "common/base/status.h"

namespace burnish {

inline constexpr size_t kSocketPathBytesMax = 107;  // limit of sockaddr_un

/// Returns true if a server of this user listens there, false if nobody does.
/// Fails: permission_denied if the server belongs to another user; as errno says.
Result<bool> user_listens(const std::filesystem::path& socket);

}  // namespace burnish
