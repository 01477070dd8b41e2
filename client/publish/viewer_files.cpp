#include "client/publish/viewer_files.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "common/base/atomic_file.h"
#include "common/base/carried_file.h"

namespace burnish {

namespace fs = std::filesystem;

std::span<const CarriedFile> carried_viewer();  // generated

// As they lie in client/web's folder of the page.
static fs::path place_of(std::string_view name) {
  if (name == "published.html") return "index.html";
  return name.ends_with(".ico") ? fs::path(name) : fs::path("assets") / name;
}

Status check_has_viewer() {
  if (!carried_viewer().empty()) return Status::ok();
  return unimplemented("this burnish was built without the page for browsers, and cannot publish");
}

bool is_of_viewer(const std::string& name) {
  return std::ranges::any_of(carried_viewer(), [&](const CarriedFile& file) {
    return *place_of(file.name).begin() == name;
  });
}

Status write_viewer(const fs::path& folder) {
  RETURN_IF_ERROR(check_has_viewer());
  std::error_code error;
  fs::create_directory(folder / "assets", error);
  if (error) return errno_status("cannot make the folder assets", error.value());
  for (const CarriedFile& file : carried_viewer())
    RETURN_IF_ERROR(write_file(folder / place_of(file.name), file.bytes));
  return Status::ok();
}

}  // namespace burnish
