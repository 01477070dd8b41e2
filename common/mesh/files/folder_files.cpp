#include "common/mesh/files/folder_files.h"

#include <algorithm>

#include "common/base/mapped_file.h"
#include "common/mesh/reading/text_values.h"

namespace burnish {

namespace fs = std::filesystem;

FolderFiles::FolderFiles(const fs::path& folder) : folder_(folder.empty() ? "." : folder) {}

static bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Returns the name in a folder that differs from this one at most by capital letters; empty: there
/// are none or several.
static std::string name_in(const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::exists(folder / name, error)) return name;
  std::string found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string here = entry->path().filename().string();
    if (!equals_ignoring_case(here, name)) continue;
    if (!found.empty()) return {};
    found = here;
  }
  return found;
}

/// Other systems do not tell capital letters, so their files name each other as they like.
static fs::path path_in(const fs::path& folder, const std::string& path) {
  fs::path found;
  for (const fs::path& part : fs::path(path)) found /= name_in(folder / found, part.string());
  return found;
}

std::optional<std::string> FolderFiles::locate(const std::string& path) const {
  std::error_code error;
  const fs::path found = path_in(folder_, path);
  const fs::path there = fs::canonical(folder_ / found, error);
  if (error || !fs::is_regular_file(there, error) || error) return std::nullopt;
  const fs::path folder = fs::canonical(folder_, error);
  if (error || !is_below(there, folder)) return std::nullopt;
  return found.generic_string();
}

Result<std::vector<uint8_t>> FolderFiles::read(const std::string& path) const {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(folder_ / path));
  return std::vector<uint8_t>(file.bytes().begin(), file.bytes().end());
}

}  // namespace burnish
