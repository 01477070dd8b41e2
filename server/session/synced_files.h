#pragma once

#include <filesystem>
#include <string_view>

#include "common/base/status.h"

namespace burnish {

/// Writes a new file and waits until its bytes are on disk. Fails: as errno says.
Status write_synced(const std::filesystem::path& path, std::string_view bytes);

/// Waits until the names in a folder are on disk.
Status sync_folder(const std::filesystem::path& folder);

/// Writes all of `bytes` to an open file. Fails: as errno says, e.g. resource_exhausted when the
/// disk is full; `what` begins the message.
Status write_all(int file, std::string_view bytes, const std::string& what);

}  // namespace burnish
