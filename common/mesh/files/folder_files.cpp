#include "common/mesh/files/folder_files.h"

#include <algorithm>

#include "common/base/mapped_file.h"

namespace burnish {

namespace fs = std::filesystem;

FolderFiles::FolderFiles(const fs::path& folder) : folder_(folder.empty() ? "." : folder) {}

static bool is_below(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

std::optional<std::string> FolderFiles::locate(const std::string& path) const {
  std::error_code error;
  const fs::path there = fs::canonical(folder_ / path, error);
  if (error || !fs::is_regular_file(there, error) || error) return std::nullopt;
  const fs::path folder = fs::canonical(folder_, error);
  if (error || !is_below(there, folder)) return std::nullopt;
  return path;
}

Result<std::vector<uint8_t>> FolderFiles::read(const std::string& path) const {
  ASSIGN_OR_RETURN(const MappedFile file, MappedFile::open(folder_ / path));
  return std::vector<uint8_t>(file.bytes().begin(), file.bytes().end());
}

}  // namespace burnish
