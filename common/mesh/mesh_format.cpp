#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "common/mesh/format_extension.h"
#include "common/mesh/mesh_io.h"

namespace burnish {

static constexpr std::pair<std::string_view, MeshFormat> kExtensions[] = {
    {".ply", MeshFormat::kPly}, {".obj", MeshFormat::kObj}, {".stl", MeshFormat::kStl},
    {".off", MeshFormat::kOff}, {".glb", MeshFormat::kGlb}, {".gltf", MeshFormat::kGltf},
    {".zip", MeshFormat::kZip},
};

std::string_view extension_of(MeshFormat format) {
  for (const auto& [extension, known] : kExtensions)
    if (known == format) return extension;
  return "";
}

Result<MeshFormat> mesh_format_of_path(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [known, format] : kExtensions)
    if (extension == known) return format;
  return invalid_argument(
      path.string() + ": extension '" + extension +
      "' is not a mesh format; use .ply, .obj, .stl, .off, .glb, .gltf or .zip");
}

Result<MeshFormat> written_format_of_path(const std::filesystem::path& path) {
  const auto format = mesh_format_of_path(path);
  if (format.is_ok()) return format;
  return invalid_argument(
      path.string() + ": extension '" + path.extension().string() +
      "' is not a mesh format that Burnish writes; use .ply, .obj, .stl, .glb or .zip");
}

}  // namespace burnish
