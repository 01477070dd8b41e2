#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "common/base/status.h"
#include "common/mesh/files/files_beside.h"

namespace burnish {

/// A file to copy: its path among the sources, and its path below the folder that it goes to.
struct FileToPlace {
  std::string source;
  std::string target;
};

/// Fails: already_exists naming a file that is there with other bytes, which place_files() would
/// not replace; as `from` cannot be read.
Status check_places(const FilesBeside& from, std::span<const FileToPlace> files,
                    const std::filesystem::path& folder);

/// Copies files into a folder, and makes folders for them. A file that is there with the same bytes
/// stays as it is. Nothing is written if one is there with other bytes, unless `replaces`.
/// Needs: targets that check_entry_name() takes. Fails: already_exists naming the file; as errno
/// says; as `from` cannot be read.
Status place_files(const FilesBeside& from, std::span<const FileToPlace> files,
                   const std::filesystem::path& folder, bool replaces);

}  // namespace burnish
