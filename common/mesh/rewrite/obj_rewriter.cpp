#include <string_view>

#include "common/mesh/rewrite/format_rewriters.h"
#include "common/mesh/rewrite/obj_normals.h"
#include "common/mesh/rewrite/text_patch.h"

namespace burnish {

Status rewrite_obj(std::span<const uint8_t> bytes, const std::string& name, const MovedMesh& moved,
                   OutputBuffer& output) {
  const std::vector<AreaVectors> normals = gather_obj_normals(bytes, moved);
  TextPatch text = {TextScanner(bytes, name, kObjSyntax), BytePatch(bytes, output)};
  uint64_t vertex = 0;
  size_t normal = 0;
  while (text.scanner.next_line()) {
    const std::string_view keyword = text.scanner.next_token();
    if (keyword == "v") RETURN_IF_ERROR(replace_position(name, moved, vertex++, text));
    if (keyword == "vn") replace_normal(normals[normal++], text);
  }
  if (vertex != moved.before.size())
    return changed_original(name, "it has " + std::to_string(vertex) + " vertices, it had " +
                                      std::to_string(moved.before.size()));
  text.patch.finish();
  return Status::ok();
}

}  // namespace burnish
