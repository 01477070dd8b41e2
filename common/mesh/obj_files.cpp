#include "common/mesh/obj_files.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "common/mesh/text_scanner.h"

namespace burnish {

namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\"";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Gathers what an OBJ and its material files name.
class ObjFileFinder {
 public:
  ObjFileFinder(const std::string& path, const FilesBeside& beside)
      : folder_(folder_of(path)), beside_(beside) {}

  Status read(std::span<const uint8_t> obj) {
    TextScanner scanner(obj, "", {.hash_comments = true, .backslash_continues = true});
    while (scanner.next_line())
      if (scanner.next_token() == "mtllib") RETURN_IF_ERROR(take_library(scanner));
    return Status::ok();
  }

  ObjFiles take() { return std::move(files_); }

 private:
  /// The line names one file, whose name may have blanks, or several.
  Status take_library(TextScanner& scanner) {
    const std::string whole(trimmed(scanner.line_rest()));
    if (const auto path = beside_.find(folder_, whole)) return read_materials(*path);
    for (std::string_view name; !(name = scanner.next_token()).empty();) {
      if (const auto path = beside_.find(folder_, name)) {
        RETURN_IF_ERROR(read_materials(*path));
      } else {
        add_once(files_.missing, std::string(name));
      }
    }
    return Status::ok();
  }

  Status read_materials(const std::string& path) {
    if (std::find(files_.found.begin(), files_.found.end(), path) != files_.found.end())
      return Status::ok();
    files_.found.push_back(path);
    ASSIGN_OR_RETURN(const auto bytes, beside_.read(path));
    ASSIGN_OR_RETURN(MaterialFile file, read_material_file(bytes, path));
    for (const std::string& picture : file.pictures) take_picture(folder_of(path), picture);
    for (Material& material : file.materials) {
      material.picture = picture_path(folder_of(path), material.picture);
      files_.materials.push_back(std::move(material));
    }
    return Status::ok();
  }

  void take_picture(const std::string& folder, const std::string& name) {
    const std::string path = picture_path(folder, name);
    if (path.empty()) {
      add_once(files_.missing, name);
    } else {
      add_once(files_.found, path);
    }
  }

  /// Programs disagree whether a picture's path begins at the material file or at the OBJ.
  std::string picture_path(const std::string& folder, const std::string& name) const {
    if (name.empty()) return "";
    auto path = beside_.find(folder, name);
    if (!path) path = beside_.find(folder_, name);
    return path.value_or("");
  }

  const std::string folder_;
  const FilesBeside& beside_;
  ObjFiles files_;
};

}  // namespace

Result<ObjFiles> find_obj_files(std::span<const uint8_t> obj, const std::string& path,
                                const FilesBeside& beside) {
  ObjFileFinder finder(path, beside);
  RETURN_IF_ERROR(finder.read(obj));
  return finder.take();
}

}  // namespace burnish
