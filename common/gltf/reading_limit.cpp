#include "common/gltf/reading_limit.h"

#include <algorithm>
#include <set>

#include "common/base/limits.h"
#include "common/gltf/document.h"

namespace burnish {

namespace {

/// Calls visit(element) for the elements of an array; none if there is no such array.
template <typename Visit>
void for_each_element(const GltfJson& object, const char* name, const Visit& visit) {
  const GltfJson* array = find_member(object, name);
  if (array == nullptr || !array->is_array()) return;
  for (const GltfJson& element : *array) visit(element);
}

uint64_t number_or(const GltfJson& object, const char* name, uint64_t absent) {
  const auto read = read_whole(object, name, "", absent);
  return read.is_ok() ? *read : absent;
}

uint64_t picture_bytes(const GltfJson& json) {
  std::set<uint64_t> views;
  for_each_element(json, "images", [&](const GltfJson& image) {
    views.insert(number_or(image, "bufferView", UINT64_MAX));
  });
  uint64_t bytes = 0;
  for (const uint64_t view : views)
    if (view < count_elements(json, "bufferViews"))
      bytes += number_or(json.at("bufferViews")[view], "byteLength", 0);
  return bytes;
}

bool is_packed(const GltfJson& json) {
  bool found = false;
  for_each_element(json, "bufferViews",
                   [&](const GltfJson& view) { found |= find_meshopt(view) != nullptr; });
  for_each_element(json, "meshes", [&](const GltfJson& mesh) {
    for_each_element(mesh, "primitives", [&](const GltfJson& primitive) {
      found |= find_object(primitive, {"extensions", kDracoExtension}) != nullptr;
    });
  });
  return found;
}

/// Returns what the accessors take as numbers of four bytes, at most `most`.
uint64_t declared_bytes(const GltfJson& json, uint64_t most) {
  uint64_t bytes = 0;
  for_each_element(json, "accessors", [&](const GltfJson& accessor) {
    const GltfJson* type = find_member(accessor, "type");
    const uint64_t components = type != nullptr && *type == "SCALAR" ? 1 : 4;
    bytes = std::min(most, bytes + 4 * components * number_or(accessor, "count", 0));
  });
  return bytes;
}

}  // namespace

uint64_t gltf_reading_bytes_max(const GltfJson& json, uint64_t file_bytes) {
  const uint64_t mesh_bytes = file_bytes - std::min(file_bytes, picture_bytes(json));
  const uint64_t plain_bytes = kReadingBytesPerFileByte * mesh_bytes;
  if (!is_packed(json)) return kGltfUnpackedBytesMin + plain_bytes;
  const uint64_t most = kGltfUnpackedBytesPerPackedByte * mesh_bytes;
  const uint64_t declared = declared_bytes(json, most);
  return kGltfUnpackedBytesMin + std::min(most, plain_bytes + kReadingBytesPerFileByte * declared);
}

}  // namespace burnish
