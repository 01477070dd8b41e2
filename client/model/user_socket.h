#pragma once

#include <filesystem>

#include "common/base/status.h"

namespace burnish {

inline constexpr size_t kSocketPathBytesMax = 107;  // of sockaddr_un

/// True when a server of this very user listens there; false when nobody does.
/// Fails: permission_denied when the server is somebody else's; as errno says.
Result<bool> user_listens(const std::filesystem::path& socket);

}  // namespace burnish
