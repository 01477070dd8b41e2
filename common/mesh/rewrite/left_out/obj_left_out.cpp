#include <string_view>
#include <utility>

#include "common/mesh/rewrite/left_out/left_out_list.h"
#include "common/mesh/rewrite/obj_normals.h"

namespace burnish {

static constexpr std::pair<std::string_view, const char*> kObjStatements[] = {
    {"vt", "texture coordinates"},
    {"vn", "normals"},
    {"mtllib", "materials"},
    {"usemtl", "materials"},
    {"g", "groups"},
    {"o", "groups"},
    {"s", "smoothing groups"},
    {"l", "lines and points"},
    {"p", "lines and points"},
    {"curv", "curves"},
    {"surf", "curves"},
};

static bool has_comment(std::span<const uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with('#') || text.find("\n#") != std::string_view::npos ||
         text.find("\r#") != std::string_view::npos;
}

bool list_obj_extras(std::span<const uint8_t> bytes, size_t triangles, const FileSteps& steps,
                     LeftOutList& list) {
  size_t faces = 0;
  for (TextScanner scanner(bytes, "", kObjSyntax, 0, steps); scanner.next_line();) {
    const std::string_view keyword = scanner.next_token();
    if (keyword == "v") continue;
    faces += keyword == "f";
    for (const auto& [statement, name] : kObjStatements) list.add_if(keyword == statement, name);
  }
  list.add_if(faces < triangles, "polygons");
  list.add_if(has_comment(bytes), "comments");
  return true;
}

}  // namespace burnish
