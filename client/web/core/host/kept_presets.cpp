// client/tools/own_presets.h where the page's store keeps the presets.

#include "client/tools/own_presets.h"
#include "client/web/core/host/store.h"

namespace burnish {

std::filesystem::path own_presets_path() {
  return "presets";
}

Result<std::string> read_own_presets_text(const std::filesystem::path& path) {
  return stored_text(path.string());
}

Status write_own_presets_text(const std::filesystem::path& path, const std::string& text) {
  store_text(path.string(), text);
  return Status::ok();
}

}  // namespace burnish
