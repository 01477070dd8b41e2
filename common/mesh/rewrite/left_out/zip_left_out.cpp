#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "common/mesh/gltf/gltf_files.h"
#include "common/mesh/reading/text_values.h"
#include "common/mesh/rewrite/left_out/left_out_list.h"

namespace burnish {

static bool ends_with_any(std::string_view name, std::span<const std::string_view> ends) {
  for (const std::string_view end : ends)
    if (name.size() >= end.size() &&
        equals_ignoring_case(name.substr(name.size() - end.size()), end))
      return true;
  return false;
}

static std::string kind_of(std::string_view name) {
  static constexpr std::array<std::string_view, 12> kPictures = {".png",  ".jpg", ".jpeg", ".tif",
                                                                 ".tiff", ".bmp", ".tga",  ".gif",
                                                                 ".webp", ".exr", ".hdr",  ".ktx2"};
  static constexpr std::array<std::string_view, 1> kMaterials = {".mtl"};
  if (ends_with_any(name, kPictures)) return "pictures";
  if (ends_with_any(name, kMaterials)) return "material files";
  return "other files of the archive";
}

/// The buffers of a glTF file are its surface, wherever they lie.
static std::vector<std::string> buffers_of(const PackedMesh& packed) {
  std::vector<std::string> paths;
  if (!is_gltf(packed.mesh.format)) return paths;
  const auto names = names_in_gltf(packed.bytes);
  if (!names.is_ok()) return paths;
  for (const std::string& name : names->buffers)
    if (auto path = ArchiveFiles(packed.archive).find(folder_of(packed.mesh.path), name))
      paths.push_back(std::move(*path));
  return paths;
}

void list_files_beside(const PackedMesh& packed, LeftOutList& list) {
  const auto& entries = packed.archive.entries();
  const std::vector<std::string> buffers = buffers_of(packed);
  for (size_t e = 0; e < entries.size(); ++e) {
    const bool is_mesh = e == packed.mesh.entry || entries[e].is_folder() ||
                         std::ranges::find(buffers, entries[e].name) != buffers.end();
    list.add_if(!is_mesh, kind_of(entries[e].name));
  }
}

}  // namespace burnish
