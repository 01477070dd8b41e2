#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

/// Copies a file to a new one, which is on disk then. It only reads and writes: a mapped file of a
/// network's file system ends the process when its server goes. Fails: data_loss if the bytes do
/// not have this SHA-256; not_found; cancelled; as errno says.
Status copy_checked(const std::filesystem::path& from, const std::string& sha256,
                    const std::filesystem::path& to, const Progress& progress);

/// Reads a file, and compares its SHA-256. Fails: likewise.
Status check_file(const std::filesystem::path& path, const std::string& sha256,
                  const Progress& progress);

/// Writes a new file that is on disk then. Fails: as errno says.
Status write_new_file(const std::filesystem::path& path, std::string_view text);

}  // namespace burnish
