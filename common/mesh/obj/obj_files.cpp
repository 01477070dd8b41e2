#include "common/mesh/obj/obj_files.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "common/mesh/reading/text_scanner.h"

namespace burnish {

namespace {

/// Names in the order in which they come, each once. A file may have a million.
class DistinctNames {
 public:
  /// Returns whether the name is new.
  bool add(const std::string& name) {
    const bool is_new = known_.insert(name).second;
    if (is_new) names_.push_back(name);
    return is_new;
  }
  std::vector<std::string> take() { return std::move(names_); }

 private:
  std::set<std::string> known_;
  std::vector<std::string> names_;
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\"";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

/// Gathers what an OBJ and its material files name.
class ObjFileFinder {
 public:
  explicit ObjFileFinder(const MeshSurroundings& beside)
      : folder_(folder_of(beside.path)), beside_(*beside.files), steps_(beside.budget) {}

  Status read(std::span<const uint8_t> obj) {
    TextScanner scanner(obj, "", {.hash_comments = true, .backslash_continues = true}, 0, steps_);
    while (scanner.next_line())
      if (scanner.next_token() == "mtllib") RETURN_IF_ERROR(take_library(scanner));
    return Status::ok();
  }

  ObjFiles take() { return {found_.take(), missing_.take(), std::move(materials_)}; }

 private:
  /// The line names one file, whose name may have blanks, or several.
  Status take_library(TextScanner& scanner) {
    const std::string whole(trimmed(scanner.line_rest()));
    if (const auto path = beside_.find(folder_, whole)) return read_materials(*path);
    for (std::string_view name; !(name = scanner.next_token()).empty();) {
      if (const auto path = beside_.find(folder_, name)) {
        RETURN_IF_ERROR(read_materials(*path));
      } else {
        missing_.add(std::string(name));
      }
    }
    return Status::ok();
  }

  Status read_materials(const std::string& path) {
    if (!found_.add(path)) return Status::ok();
    ASSIGN_OR_RETURN(const auto bytes, beside_.read(path));
    ASSIGN_OR_RETURN(MaterialFile file, read_material_file(bytes, path, steps_));
    for (const std::string& picture : file.pictures) take_picture(folder_of(path), picture);
    for (Material& material : file.materials) {
      material.picture = picture_path(folder_of(path), material.picture);
      materials_.push_back(std::move(material));
    }
    return Status::ok();
  }

  void take_picture(const std::string& folder, const std::string& name) {
    const std::string path = picture_path(folder, name);
    if (path.empty()) {
      missing_.add(name);
    } else {
      found_.add(path);
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
  const FileSteps steps_;
  DistinctNames found_, missing_;
  std::vector<Material> materials_;
};

}  // namespace

Result<ObjFiles> find_obj_files(std::span<const uint8_t> obj, const MeshSurroundings& beside) {
  ObjFileFinder finder(beside);
  RETURN_IF_ERROR(finder.read(obj));
  return finder.take();
}

}  // namespace burnish
