#include "common/mesh/rewrite/gltf/gltf_images.h"

#include <string>

#include "common/gltf/base64.h"
#include "common/mesh/rewrite/gltf/gltf_view_range.h"

namespace burnish {

namespace {

/// Returns how many objects of the document's array `list` name a view.
size_t count_users(const GltfJson& json, const char* list, uint64_t view) {
  size_t users = 0;
  for (size_t i = 0; i < count_elements(json, list); ++i)
    users += whole_or(json.at(list)[i], "bufferView", UINT64_MAX) == view ? 1 : 0;
  return users;
}

/// Returns whether something else uses bytes of a view.
bool is_shared(const GltfJson& json, uint64_t view) {
  const GltfJson& views = json.at("bufferViews");
  const GltfViewRange range(views[view]);
  for (size_t other = 0; other < views.size(); ++other)
    if (other != view && GltfViewRange(views[other]).meets(range)) return true;
  return count_users(json, "images", view) > 1 || count_users(json, "accessors", view) > 0;
}

}  // namespace

void put_gltf_image(GltfEdit& edit, uint32_t image, std::span<const uint8_t> bytes) {
  GltfJson& json = edit.json()["images"][image];
  if (json.contains("uri")) {
    const auto before = json["uri"].get<std::string>();
    json["uri"] = before.substr(0, before.find(',') + 1) + to_base64(bytes);
    return;
  }
  const auto view = json.at("bufferView").get<uint64_t>();
  if (is_shared(edit.json(), view)) {
    const uint64_t own = edit.append_view(bytes, 0);
    edit.json()["images"][image]["bufferView"] = own;
  } else {
    edit.replace_view(view, bytes);
  }
}

}  // namespace burnish
