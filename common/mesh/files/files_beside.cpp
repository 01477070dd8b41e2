#include "common/mesh/files/files_beside.h"

#include <algorithm>
#include <filesystem>

namespace burnish {

static std::string joined(std::string_view folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).lexically_normal().generic_string();
}

static bool leads_elsewhere(const std::string& path) {
  return path.empty() || path.front() == '/' || path == ".." || path.starts_with("../") ||
         path.find(':') != std::string::npos || path.find('\0') != std::string::npos;
}

std::string folder_of(std::string_view path) {
  const size_t slash = path.rfind('/');
  return std::string(slash == std::string_view::npos ? "" : path.substr(0, slash));
}

std::optional<std::string> FilesBeside::find(std::string_view folder, std::string_view name) const {
  std::string written(name);
  std::replace(written.begin(), written.end(), '\\', '/');
  const std::string last = written.substr(written.rfind('/') + 1);
  for (const std::string& path : {joined(folder, written), joined(folder, last)}) {
    if (leads_elsewhere(path)) continue;
    if (auto found = locate(path)) return found;
  }
  return std::nullopt;
}

}  // namespace burnish
