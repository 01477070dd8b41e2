#pragma once

#include <filesystem>

#include "common/base/status.h"

namespace burnish {

/// Makes a folder that only this user can enter (0700), with the folders above it where they are
/// missing. One of ours that others could only read is closed to them: older versions left it open.
/// Fails: permission_denied where it is somebody else's, others could write into it, or it is a
/// link or a file; as errno says.
Status make_private_folder(const std::filesystem::path& folder);

}  // namespace burnish
