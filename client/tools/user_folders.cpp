#include "client/tools/user_folders.h"

#include <cstdlib>

namespace burnish {

namespace fs = std::filesystem;

static fs::path folder_in(const char* variable) {
  const char* const value = std::getenv(variable);
  return value ? value : "";
}

static fs::path folder_of(const char* variable, const char* below_home) {
  if (const fs::path folder = folder_in(variable); !folder.empty()) return folder / "burnish";
  const fs::path home = home_folder();
  return home.empty() ? home : home / below_home / "burnish";
}

fs::path home_folder() {
  return folder_in("HOME");
}

fs::path config_folder() {
  return folder_of("XDG_CONFIG_HOME", ".config");
}

fs::path cache_folder() {
  return folder_of("XDG_CACHE_HOME", ".cache");
}

fs::path data_folder() {
  return folder_of("XDG_DATA_HOME", ".local/share");
}

}  // namespace burnish
