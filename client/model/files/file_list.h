#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/base/status.h"

namespace burnish {

inline constexpr size_t kFilesListedMax = 10'000;

/// A file or folder in a list.
struct ListedFile {
  std::string name;
  bool is_folder = false;
  uint64_t size_bytes = 0;           ///< 0 for a folder
  int64_t changed_unix_seconds = 0;  ///< last write
};

/// A folder that a user goes to often.
struct Place {
  std::string name;
  std::filesystem::path folder;
};

/// Lists a folder: folders first, then files, both by name. Hidden ones are left out, and files
/// without one of these extensions (".ply", in any case; empty: all), and what comes after
/// kFilesListedMax. Fails: as errno says; the message names the folder.
Result<std::vector<ListedFile>> list_folder(const std::filesystem::path& folder,
                                            const std::vector<std::string>& extensions);

/// Returns whether a name has the typed text in it. Latin letters match in any case.
bool has_text(const std::string& name, const std::string& typed);

/// Returns the home folder, its Desktop, Documents and Downloads, and these recent folders, as far
/// as they are there.
std::vector<Place> places_to_look(const std::vector<std::filesystem::path>& recent);

}  // namespace burnish
