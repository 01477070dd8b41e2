#include <string>
#include <utility>

#include "common/base/limits.h"
#include "common/base/text.h"
#include "common/gltf/document.h"
#include "common/mesh/rewrite/left_out/left_out_list.h"

namespace burnish {

static void list_primitive(const GltfJson& primitive, LeftOutList& list) {
  const GltfJson* attributes = find_object(primitive, {"attributes"});
  if (attributes == nullptr) return;
  for (const auto& item : attributes->items()) {
    const std::string& name = item.key();
    if (name == "POSITION" || name == "COLOR_0") continue;
    if (name == "NORMAL" || name == "TANGENT") {
      list.add("normals");
    } else if (name.starts_with("TEXCOORD_")) {
      list.add("texture coordinates");
    } else {
      list.add("attribute " + shortened(name, kNameBytesMax));
    }
  }
  const GltfJson* mode = find_member(primitive, "mode");
  list.add_if(mode != nullptr && *mode < 4, "lines and points");
}

bool list_gltf_extras(std::span<const uint8_t> bytes, LeftOutList& list) {
  const auto read = read_gltf_json(bytes);
  if (!read.is_ok()) return false;
  const GltfJson& json = *read;
  for (size_t m = 0; m < count_elements(json, "meshes"); ++m) {
    const GltfJson* primitives = find_member(json.at("meshes")[m], "primitives");
    if (primitives == nullptr || !primitives->is_array()) continue;
    for (const GltfJson& primitive : *primitives) list_primitive(primitive, list);
  }
  constexpr std::pair<const char*, const char*> kParts[] = {{"materials", "materials"},
                                                            {"textures", "textures"},
                                                            {"images", "pictures"},
                                                            {"cameras", "cameras"},
                                                            {"animations", "animations"}};
  for (const auto& [member, name] : kParts) list.add_if(count_elements(json, member) > 0, name);
  list.add_if(count_elements(json, "nodes") > 1, "nodes and their names");
  return true;
}

}  // namespace burnish
