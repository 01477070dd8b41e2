#include "common/mesh/rewrite/zip_left_out.h"

#include <array>
#include <string_view>

#include "common/mesh/text_values.h"

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

void list_files_beside(const PackedMesh& packed, LeftOutList& list) {
  const auto& entries = packed.archive.entries();
  for (size_t e = 0; e < entries.size(); ++e)
    list.add_if(e != packed.mesh.entry && !entries[e].is_folder(), kind_of(entries[e].name));
}

}  // namespace burnish
