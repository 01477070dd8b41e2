#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "common/base/progress.h"
#include "common/base/status.h"

namespace burnish {

/// Takes the next bytes.
using TakePiece = std::function<Status(std::string_view piece)>;
/// Hands over all bytes of something.
using Pieces = std::function<Status(const TakePiece& take)>;

/// Writes bytes to a new file, which is on disk then. `name`: theirs in messages. Fails: data_loss
/// if they do not have this SHA-256; as `from`; as errno says.
Status write_checked(const std::string& name, const std::string& sha256,
                     const std::filesystem::path& to, const Pieces& from);

/// Compares the SHA-256 of bytes. Fails: likewise.
Status check_pieces(const std::string& name, const std::string& sha256, const Pieces& from);

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
