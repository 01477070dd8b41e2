#pragma once

#include <filesystem>

#include "common/base/status.h"

namespace burnish {

/// Makes a folder that only this user can enter (0700), and missing folders above it. Closes an
/// existing folder that others can read but not write: older versions left it open.
/// Fails: permission_denied if it belongs to another user, others can write into it, or it is a
/// link or a file; as errno says.
Status make_private_folder(const std::filesystem::path& folder);

}  // namespace burnish
