#include "common/mesh/gltf/gltf_files.h"

#include <string_view>

#include "common/gltf/data_uri.h"

namespace burnish {

GltfFilesBeside GltfFiles::reader() {
  if (beside_.files == nullptr) return nullptr;
  return [this](const std::string& name) { return read(name); };
}

Result<std::span<const uint8_t>> GltfFiles::read(const std::string& name) {
  const auto known = files_.find(name);
  if (known != files_.end()) return std::span<const uint8_t>(known->second.bytes);
  const auto path = beside_.files->find(folder_of(beside_.path), name);
  if (!path) return invalid_argument("the file '" + name + "' that it names is not beside it");
  ASSIGN_OR_RETURN(auto bytes, beside_.files->read(*path));
  const File& file = files_[name] = {*path, std::move(bytes)};
  return std::span<const uint8_t>(file.bytes);
}

static std::vector<std::string> names_in_list(const GltfJson& json, const char* list) {
  std::vector<std::string> names;
  for (size_t i = 0; i < count_elements(json, list); ++i) {
    const GltfJson* uri = find_member(json.at(list)[i], "uri");
    if (uri == nullptr || !uri->is_string()) continue;
    const auto name = uri->get<std::string>();
    if (!is_data_uri(name)) names.push_back(unescaped_uri(name));
  }
  return names;
}

Result<GltfNames> names_in_gltf(std::span<const uint8_t> bytes) {
  ASSIGN_OR_RETURN(const GltfJson json, read_gltf_json(bytes));
  return GltfNames{names_in_list(json, "buffers"), names_in_list(json, "images")};
}

}  // namespace burnish
