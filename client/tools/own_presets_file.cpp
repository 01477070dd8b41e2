// The file of the user's own presets.

#include "client/tools/own_presets.h"
#include "client/tools/user_folders.h"
#include "common/base/atomic_file.h"
#include "common/base/text_lines.h"

namespace burnish {

std::filesystem::path own_presets_path() {
  const std::filesystem::path folder = config_folder();
  return folder.empty() ? folder : folder / "presets";
}

Result<std::string> read_own_presets_text(const std::filesystem::path& path) {
  std::error_code ignored;
  if (path.empty() || !std::filesystem::exists(path, ignored)) return std::string();
  return read_text_file(path);
}

Status write_own_presets_text(const std::filesystem::path& path, const std::string& text) {
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  return write_file(path, text);
}

}  // namespace burnish
